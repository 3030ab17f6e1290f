#include "report/internal_account.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "image/png.h"
#include "math/camera_projection.h"
#include "picture/recording_renderer.h"
#include "recording/notes.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "report/internal_plots.h"
#include "report/internal_table.h"
#include "report/wording.h"
#include "scene/units.h"

// Notes are what a program knew at the time, in its own words and measures. Only the pictures are
// drawn again, from the recording, as its eye saw them; nothing is compared with the truth here.

namespace smile::report {
namespace {

using recording::RecordedNote;

/// Returns true for a note that compares what was expected with what was seen.
bool IsVerdict(const RecordedNote& note) {
  return note.note.word == "as expected" || note.note.word == "hidden" ||
         note.note.word == "contradicted";
}

/// Returns true for a note of what a picture shows, other than the plan's.
bool IsOfPicture(const RecordedNote& note) {
  return IsVerdict(note) || (note.note.word == "saw" && !note.note.camera.empty());
}

/// Notes with one picture: an action or the first look, and what came of it.
using NoteGroup = std::vector<const RecordedNote*>;

/// Draws what a program knew over what one of its cameras saw.
class AccountPictures {
 public:
  explicit AccountPictures(const recording::Recording& recording)
      : recording_(recording), cameras_(model::CameraNames(*recording.model)), trace_(recording) {}

  /// Returns the picture of a camera at a tick with the tops that notes name; empty if the tick was
  /// not recorded, or there is no such camera.
  ///
  /// @param camera  empty: the robot's eye.
  Markup At(std::uint64_t tick, const std::string& camera, const NoteGroup& notes,
            const std::string& words) {
    const auto moment = trace_.At(tick);
    const std::string name = camera.empty() ? recording_.info.eye_camera : camera;
    if (!moment || std::ranges::find(cameras_, name) == cameras_.end()) return {};
    const model::EyeSpec spec{.width_px = kWidth, .height_px = kHeight, .camera = name};
    const CameraView view = recording::ViewSampleAt(*moment, *recording_.model, spec).view;
    Markup outlines;
    const RecordedNote* former = nullptr;
    for (const RecordedNote* it : notes) {
      std::string mark;
      if (it->note.word == "contradicted") mark = " bad";
      if (it->note.word == "hidden") mark = " unseen";
      // The first verdict after an action is on what that moved.
      if (former != nullptr && former->note.word == "action") mark += " moved";
      former = it;
      if (it->note.word == "action") continue;  // what it expects, that verdict repeats
      for (const auto& top : it->note.expected) outlines += Outline(top, view, "expected" + mark);
    }
    for (const RecordedNote* it : notes) {
      for (const auto& top : it->note.found) outlines += Outline(top, view, "found");
    }
    Markup both = Picture(EncodePng(RendererOf(name).Take(*moment)), words);
    both += Drawing(kWidth, kHeight, words, outlines);
    return Element("div", {{"class", "seen"}}, both);
  }

 private:
  static constexpr int kWidth = 384, kHeight = 288;  // [px]

  picture::RecordingRenderer& RendererOf(const std::string& camera) {
    const picture::RenderRequest request{.camera = model::kEyeCamera,
                                         .eye = camera,
                                         .width_px = kWidth,
                                         .height_px = kHeight,
                                         .channels = {}};
    return renderers_.try_emplace(camera, *recording_.model, request).first->second;
  }

  Markup Outline(const sim::NotedTop& top, const CameraView& view,
                 const std::string& css_class) const {
    const Eigen::Rotation2Dd turn(top.yaw);
    const int num_corners = top.is_round ? 24 : 4;
    std::string points;
    for (int k = 0; k < num_corners; ++k) {
      // The corners of a rectangle lie on the diagonals, those of an ellipse on its border.
      const double angle = (2 * k + 1) * std::numbers::pi / num_corners;
      const double reach = top.is_round ? 0.5 : std::numbers::sqrt2 / 2;
      const Eigen::Vector2d away = turn * Eigen::Vector2d(reach * std::cos(angle) * top.length,
                                                          reach * std::sin(angle) * top.width);
      const Vector3 p_WQ = scene::FromFileUnits(top.middle + Vector3(away.x(), away.y(), 0),
                                                recording_.scene().meters_per_unit);
      const Vector3 p_CQ = view.X_WC.inverse() * p_WQ;
      if (p_CQ.z() < view.intrinsics.near) return {};  // behind the camera
      const Eigen::Vector2d pixel = ProjectToPixel(view.intrinsics, p_CQ);
      points += report::At(pixel.x()) + "," + report::At(pixel.y()) + " ";
    }
    return Element("polygon", {{"points", points}, {"class", css_class}});
  }

  const recording::Recording& recording_;
  std::vector<std::string> cameras_;
  std::map<std::string, picture::RecordingRenderer> renderers_;  ///< by their cameras
  recording::TraceReader trace_;
};

/// Returns sentences: a line that ends with a colon is the headline of those that follow.
Markup SentencesOf(const std::vector<RecordedNote>& notes) {
  Markup page, list;
  const auto close = [&] {
    if (!list.is_empty()) page += Element("ul", {}, list);
    list = {};
  };
  for (const RecordedNote& it : notes) {
    if (it.note.word != "understood") continue;
    if (it.note.text.ends_with(':')) {
      close();
      page += Element("h3", {}, it.note.text);
    } else {
      list += Element("li", {}, it.note.text);
    }
  }
  close();
  return page.is_empty() ? page : Element("div", {{"class", "told"}}, page);
}

Markup LegendOf() {
  Markup legend;
  for (const auto& [css_class, words] :
       {std::pair("line", "expected, and seen   "),
        std::pair("line unseen", "expected, but hidden   "),
        std::pair("line bad", "expected, but contradicted   "), std::pair("line found", "seen")}) {
    legend += Element("span", {{"class", css_class}}, Markup());
    legend += Text(words);
  }
  return Element("p", {{"class", "note legend"}}, legend);
}

/// Returns the plan, with a picture of the first look in which its places are drawn.
Markup PlanOf(const std::vector<RecordedNote>& notes, AccountPictures* pictures) {
  NoteGroup plan;
  Markup list;
  for (const RecordedNote& it : notes) {
    if (it.note.word != "plan") continue;
    plan.push_back(&it);
    list += Element("li", {}, it.note.text);
  }
  if (plan.empty()) return {};
  NoteGroup drawn = plan;
  for (const RecordedNote& it : notes) {
    if (it.note.word == "saw" && it.tick == plan.front()->tick) drawn.push_back(&it);
  }
  const std::string words = "The first look: where everything is to go, and, black, what was seen";
  Markup figure = pictures->At(plan.front()->tick, "", drawn, words);
  figure += Element("figcaption", {}, words);
  Markup pair = Element("figure", {}, figure);
  pair += Element("ol", {}, list);
  return Section("What it planned", Element("div", {{"class", "actions plan"}}, pair));
}

/// Returns an action with what a picture afterwards shows.
Markup ActionOf(const NoteGroup& group, const recording::Recording& recording,
                AccountPictures* pictures) {
  Markup words;
  const RecordedNote* seen = nullptr;
  for (const RecordedNote* it : group) {
    if (!IsOfPicture(*it)) {
      const double seconds = SecondsInto(recording, it->tick);
      words += Element("h3", {}, Fixed(seconds, 1) + " s: " + it->note.text);
      continue;
    }
    seen = it;
    Markup line = Badge(it->note.word != "contradicted", it->note.word);
    line += Text(" " + it->note.text);
    words += Element("p", {}, line);
  }
  Markup action;
  if (seen != nullptr) {
    const std::string& camera = seen->note.camera;
    action = pictures->At(seen->tick, camera, group,
                          camera.empty() ? "What the robot's eye saw afterwards"
                                         : "What the camera " + camera + " saw");
  }
  action += words;
  return Element("div", {}, action);
}

/// Returns the actions, and pictures that were compared with what was expected, in their order.
std::vector<NoteGroup> GroupsOf(const std::vector<RecordedNote>& notes) {
  // Far more than a run of ten minutes has: a program may note what it likes, and each has a
  // picture.
  constexpr std::size_t kMaxGroups = 200;
  std::vector<NoteGroup> groups;
  for (const RecordedNote& it : notes) {
    const bool is_action = it.note.word == "action";
    if (!is_action && !IsOfPicture(it)) continue;
    // A picture belongs to the action before it; another one, to none.
    const bool is_next =
        groups.empty() || is_action ||
        (IsOfPicture(*groups.back().back()) && groups.back().back()->tick != it.tick);
    if (is_next && groups.size() == kMaxGroups) break;
    if (is_next) groups.emplace_back();
    groups.back().push_back(&it);
  }
  return groups;
}

Markup ActionsOf(const std::vector<RecordedNote>& notes, const recording::Recording& recording,
                 AccountPictures* pictures) {
  Markup actions;
  for (const NoteGroup& group : GroupsOf(notes)) actions += ActionOf(group, recording, pictures);
  if (actions.is_empty()) return {};
  Markup content = Element(
      "p", {{"class", "note"}},
      "After each action the robot's program compares a picture with what it expected to see. "
      "Outlines are where it expected and where it saw the tops of objects.");
  content += LegendOf();
  content += Element("div", {{"class", "actions"}}, actions);
  return Section("What it did, expected and saw", content);
}

}  // namespace

Markup AccountOf(const recording::Recording& imitation) {
  const std::vector<RecordedNote> notes = NotesOf(imitation);
  if (notes.empty()) return {};
  Markup account;
  const Markup understood = SentencesOf(notes);
  if (!understood.is_empty())
    account += Section("What it understood of the demonstration", understood);
  AccountPictures pictures(imitation);
  account += PlanOf(notes, &pictures);
  account += ActionsOf(notes, imitation, &pictures);
  return account;
}

}  // namespace smile::report
