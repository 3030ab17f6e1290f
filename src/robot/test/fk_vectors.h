#pragma once

#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/rigid_transform.h"

namespace smile::robot {

/// Row of data/baxter_fk_vectors.csv: pose of the left or right hand by independent arithmetic.
struct FkVector {
  std::string arm, name;
  std::vector<double> q;  ///< s0 … w2 [rad]
  Vector3 p_BaseHand;
  Quaternion q_BaseHand;
  Vector3 p_BaseTip;  ///< 0.1577 m beyond the hand
  std::optional<Eigen::Matrix<double, 6, 7>> J;
};

inline std::vector<FkVector> ReadFkVectors() {
  std::ifstream file(SMILE_SOURCE_DIR "/src/robot/test/data/baxter_fk_vectors.csv");
  std::vector<FkVector> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#") || line.starts_with("arm,")) continue;
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (cells.size() < 20) throw std::runtime_error("bad row: " + line);
    const auto number = [&](std::size_t column) { return std::stod(cells.at(column)); };

    FkVector row{.arm = cells[0], .name = cells[2]};
    for (std::size_t i = 3; i < 10; ++i) row.q.push_back(number(i));
    row.p_BaseHand = {number(10), number(11), number(12)};
    row.q_BaseHand = Quaternion(number(13), number(14), number(15), number(16));
    row.p_BaseTip = {number(17), number(18), number(19)};
    if (cells.size() > 20 && !cells[20].empty()) {
      row.J.emplace();
      for (int i = 0; i < 42; ++i) (*row.J)(i / 7, i % 7) = number(20 + std::size_t(i));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace smile::robot
