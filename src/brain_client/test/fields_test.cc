#include "brain_client/brain.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "wire/test/wire_verbs.h"

namespace smile::brain_client {
namespace {

/// Fields of a step.
Fields SampleFields() {
  wire::MessageWriter writer(wire::MessageType::kStep, 1);
  writer.AddScalar("simTime", 2.5);
  writer.AddDoubles("gripperOpening", std::array{1u, 2u}, std::array{0.5, 1.5});
  writer.AddText("path", "brains/");
  const auto planes =
      writer.AddSpace("rgbVision", wire::ElementType::kByte, true, std::array{2u, 3u, 3u});
  for (std::size_t k = 0; k < planes.size(); ++k) planes[k] = std::byte(k);
  return Fields(wire::Decoded(writer.Finish()));
}

template <class Ask>
std::string ErrorOf(Ask ask) {
  try {
    ask(SampleFields());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Fields, AreReadByName) {
  const Fields fields = SampleFields();
  EXPECT_EQ(fields.Number("simTime"), 2.5);
  EXPECT_EQ(fields.Matrix("gripperOpening"), Eigen::RowVector2d(0.5, 1.5));
  EXPECT_EQ(fields.Text("path"), "brains/");
  EXPECT_TRUE(fields.Has("simTime"));
  EXPECT_FALSE(fields.Has("depth"));
}

TEST(Fields, ConvertPicturesToRowMajor) {
  const Image image = SampleFields().Picture("rgbVision");
  EXPECT_EQ(image.width_px, 3);
  EXPECT_EQ(image.height_px, 2);
  // On the wire: 6 reds column by column, then 6 greens, then 6 blues.
  const std::vector<std::uint8_t> first_row{0, 6, 12, 2, 8, 14, 4, 10, 16};
  EXPECT_TRUE(std::equal(first_row.begin(), first_row.end(), image.color.begin()));
  EXPECT_EQ(image.color[9], 1);
}

TEST(Fields, AcceptRowMajorArrays) {
  wire::MessageWriter writer(wire::MessageType::kStep, 1);
  const auto pixels = writer.AddSpace("rgbVision", wire::ElementType::kByte, true,
                                      std::array{1u, 2u, 3u}, /*is_row_major=*/true);
  for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] = std::byte(k);
  const auto depths = writer.AddSpace("depthVision", wire::ElementType::kByte, false,
                                      std::array{2u, 2u}, /*is_row_major=*/true);
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = std::byte(k);
  const Fields fields(wire::Decoded(writer.Finish()));
  EXPECT_EQ(fields.Picture("rgbVision").color, (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(fields.Matrix("depthVision")(0, 1), 1);
}

TEST(Fields, ErrorsNameTheAvailableFields) {
  EXPECT_EQ(ErrorOf([](const Fields& fields) { fields.Number("time"); }),
            "time is missing, found simTime, gripperOpening, path, rgbVision");
  EXPECT_EQ(ErrorOf([](const Fields& fields) { fields.Number("gripperOpening"); }),
            "gripperOpening is 1x2, expected one number");
  EXPECT_EQ(ErrorOf([](const Fields& fields) { fields.Matrix("path"); }),
            "path is text, expected a matrix");
  EXPECT_EQ(ErrorOf([](const Fields& fields) { fields.Picture("simTime"); }),
            "simTime is 1x1, expected HxWx3 bytes");
}

}  // namespace
}  // namespace smile::brain_client
