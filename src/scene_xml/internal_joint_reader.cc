#include "scene_xml/internal_joint_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/wording.h"
#include "scene_xml/internal_object_reader.h"
#include "scene_xml/internal_tool_reader.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/value_ranges.h"

// Joints between whole objects. In the file a slider contains its two members and a chain is one
// line; in the scene their objects are in the common list, and the joint has the index of its
// first.

namespace smile::scene_xml {
namespace {

// Shortest distance of the ends of a chain: the direction of its links follows from them.
constexpr double kMinChainUnits = 0.001;
/// Tolerance for rounding, as a fraction of a link's length.
constexpr double kFit = 1e-9;

/// Reads the range of a slider and its initial offset, which defaults to the offset nearest to 0.
void ReadRange(AttributeReader* attributes, scene::SliderSpec* slider) {
  slider->min_offset = attributes->Distance("min", 0);
  slider->max_offset = attributes->Distance("max", 1);
  if (slider->min_offset > slider->max_offset) {
    // After another fault the values are defaults, and comparing them would report a fault of ours.
    if (!attributes->has_findings()) attributes->Refuse("min", "at most max");
    return;
  }
  if (!attributes->Text("init")) {
    slider->initial_offset = std::clamp(0.0, slider->min_offset, slider->max_offset);
    return;
  }
  slider->initial_offset = attributes->Distance("init", 0);
  const bool is_within =
      slider->min_offset <= slider->initial_offset && slider->initial_offset <= slider->max_offset;
  if (!is_within && !attributes->has_findings()) attributes->Refuse("init", "min to max");
}

scene::SliderSpec ReadSliderAttributes(AttributeReader* attributes) {
  scene::SliderSpec slider{.id = attributes->Id(), .X_WJ = attributes->Pose()};
  ReadRange(attributes, &slider);
  slider.do_members_collide = attributes->Boolean("collision", slider.do_members_collide);
  slider.damping = attributes->Number("damping", slider.damping, kProportion);
  slider.restitution = attributes->Number("restitution", slider.restitution, kProportion);
  slider.softness = attributes->Number("softness", slider.softness, kProportion);
  attributes->Boolean("pointable", false);  // says nothing about a joint
  attributes->RefuseUnknown();
  return slider;
}

/// Returns the number of links: as wanted, if they reach from start to end, or the fewest that do
/// if 0 is wanted; nullopt, with a finding, if there is no such number.
std::optional<int> NumLinks(const scene::ChainSpec& chain, int wanted, double meters_per_unit,
                            AttributeReader* attributes) {
  const double distance = (chain.p_WEnd - chain.p_WStart).norm();
  const double length = chain.link_size.y();
  if (distance < MetersFromUnits(kMinChainUnits, meters_per_unit)) {
    attributes->Refuse("end", "a place at least 0.001 units from start");
    return std::nullopt;
  }
  // A distance of exactly n links must give n, although the quotient may be a bit larger.
  const double fitting = std::max(1.0, std::ceil(distance / length - kFit));
  if (wanted == 0) {
    // Compared as a double, which cannot overflow.
    if (fitting <= kMaxLinks) return static_cast<int>(fitting);
    attributes->Refuse("linkYspan", "links so long that " + std::to_string(kMaxLinks) +
                                        " of them reach from start to end");
    return std::nullopt;
  }
  // Half a link may be missing, since the end pieces bridge the gap.
  if (wanted * length >= distance - length / 2 - kFit * length) return wanted;
  attributes->Refuse("linkCount", NumberText(std::ceil(distance / length - 0.5 - kFit)) +
                                      " or more, to reach from start to end");
  return std::nullopt;
}

}  // namespace

void ReadSlider(const SceneElement& element, ReadingContext* reading, ObjectList* objects) {
  AttributeReader attributes(element, reading);
  scene::SliderSpec slider = ReadSliderAttributes(&attributes);
  std::vector<scene::ObjectSpec> members;
  std::vector<SourceLocation> places;
  for (const SceneElement& child : element.children) {
    if (const ShapeElement* shape = FindShape(child, Container::kSlider, reading)) {
      members.push_back(ReadObject(child, *shape, Container::kSlider, reading));
      places.push_back(child.place);
    }
  }
  if (members.size() != 2) {
    return attributes.AddFinding("found " + std::to_string(members.size()) +
                                 (members.size() == 1 ? " object" : " objects") +
                                 " inside, expected two: one slides on the other");
  }
  if (members[0].is_static() && members[1].is_static()) {
    attributes.AddFinding("found two objects of mass 0, expected one that can move");
  }
  if (!objects->HasRoomFor(2, element.place)) return;
  // In the file, members are placed relative to the joint frame J; objects of a scene are placed in
  // the world.
  slider.X_JA = members[0].whole.X_PE;
  slider.X_JB = members[1].whole.X_PE;
  members[0].whole.X_PE = slider.pose_of_first();
  members[1].whole.X_PE = slider.pose_of_second();
  slider.first_object = objects->scene().objects.size();
  for (int i : {0, 1}) objects->Add(std::move(members[i]), places[i]);
  objects->scene().sliders.push_back(std::move(slider));
}

void ReadChain(const SceneElement& element, ReadingContext* reading, ObjectList* objects) {
  AttributeReader attributes(element, reading);
  scene::ChainSpec chain{.id = attributes.ClaimedId()};
  chain.color = attributes.Color();
  chain.p_WStart = attributes.Point("start");
  chain.p_WEnd = attributes.Point("end");
  const double x = attributes.Span("linkXspan", 0.1);
  const double y = attributes.Span("linkYspan", 1);
  const double z = attributes.Span("linkZspan", 0.1);
  chain.link_size = {x, y, z};
  const int wanted = attributes.Count("linkCount", 0, kNumLinks);
  chain.link_padding = attributes.SpanOrZero("linkPadding", 0.05);
  chain.link_mass = attributes.Number("linkMass", chain.link_mass, kLinkMassKilograms);
  chain.can_be_cut = ReadCut(chain.can_be_cut, &attributes);
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  if (attributes.has_findings()) return;
  const std::optional<int> num_links =
      NumLinks(chain, wanted, reading->meters_per_unit, &attributes);
  // The links and the two end pieces.
  if (!num_links || !objects->HasRoomFor(*num_links + 2, element.place)) return;

  // Ids in the order of the pieces, as the counter of renamed ids depends on it.
  chain.start_id = reading->ids.Claim(chain.id + "-start");
  chain.end_id = reading->ids.Claim(chain.id + "-end");
  for (int i = 0; i < *num_links; ++i) {
    chain.link_ids.push_back(reading->ids.Claim(chain.id + "-link" + std::to_string(i)));
  }
  chain.first_object = objects->scene().objects.size();
  for (scene::ObjectSpec& piece : PiecesOf(chain, reading->meters_per_unit)) {
    objects->Add(std::move(piece), element.place);
  }
  objects->scene().chains.push_back(std::move(chain));
}

}  // namespace smile::scene_xml
