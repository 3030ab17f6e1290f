#pragma once

#include "interchange/internal_mjcf_geoms.h"

namespace smile::interchange {

/// Writer of a robot in MJCF, whose parts stand in different places of the file.
class MjcfRobot {
 public:
  /// All must outlive this; the world must have a robot.
  MjcfRobot(const ExportedWorld& world, MjcfGeoms* geoms, xml::Writer* xml)
      : world_(world), robot_(*world.robot), geoms_(*geoms), xml_(*xml) {}

  /// Writes the tree of its links, with their joints and cameras.
  void WriteBodies();
  /// Writes the joints that others move, as equalities.
  void WriteFollowers();
  /// Writes a velocity servo for each motor.
  void WriteServos();
  /// Returns the name of a link.
  /// @param link  -1: the base.
  const std::string& NameOf(int link) const;

 private:
  void WriteCamerasOn(int link);
  void WriteLinksOn(int parent);
  void WriteLink(int index);

  const ExportedWorld& world_;
  const ExportedRobot& robot_;
  MjcfGeoms& geoms_;
  xml::Writer& xml_;
};

}  // namespace smile::interchange
