#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "base/files.h"
#include "page/page_protocol.h"
#include "robot/urdf_reader.h"
#include "studio/session.h"
#include "texts/message_json.h"

namespace smile::studio {

/// Session without a network, in a temporary directory. Requests are written as a page sends them;
/// all messages must fit the tables of the protocol.
class SessionFixture : public ::testing::Test {
 protected:
  SessionFixture() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = std::filesystem::temp_directory_path() /
            ("smile_studio_" + std::to_string(getpid()) + "_" + test->name());
    std::filesystem::create_directories(root_ / "scenes");
    WriteFile(root_ / "scenes/pair.xml", kPair);
    WriteFile(root_ / "scenes/pair_elsewhere.xml", kPairElsewhere);
  }
  ~SessionFixture() override {
    session_.reset();
    jobs_.reset();
    std::filesystem::remove_all(root_);
  }

  static constexpr const char* kPair =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" color="red" location="(0, -2, 0.5)"/>
  <block id="b" color="blue" location="(3, -2, 0.5)"/>
</tabletop>)xml";
  static constexpr const char* kPairElsewhere =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" color="red" location="(-3, -2, 0.5)"/>
  <block id="b" color="blue" location="(3, -3, 0.5)"/>
</tabletop>)xml";

  static sim::RobotPlacement Baxter() {
    static const robot::RobotReading kBaxter = robot::LoadRobot(DataFile("robots/baxter.urdf"));
    return {.model = kBaxter.model, .gripper = kBaxter.gripper, .files = kBaxter.files};
  }

  void Begin(sim::Eye* eye = nullptr, bool with_robot = false) {
    BeginWith(eye, with_robot ? std::optional(Baxter()) : std::nullopt);
  }
  void BeginWith(sim::Eye* eye, std::optional<sim::RobotPlacement> robot) {
    SessionOptions options{.scene = root_ / "scenes/pair.xml",
                           .recordings = root_ / "recordings",
                           .eye = eye,
                           .scene_folder = root_ / "scenes",
                           .brains = {root_ / "brains"},
                           .jobs = &*jobs_};
    options.robot = std::move(robot);
    session_ = std::make_unique<Session>(std::move(options));
    session_->requests().deferred.emplace_back([this] { return jobs_->TakeDeferred(); });
  }

  Json Ask(const std::string& text) { return AskWith(ParseJson(text)); }
  Json AskWith(const Json& fields) {
    const Json answer = BeginToAsk(fields);
    return page::IsLater(answer) ? LaterAnswer() : answer;
  }
  Json BeginToAsk(const Json& fields) {
    std::string what;
    if (fields.contains("do") && fields["do"].is_string()) what = fields["do"];
    const Json answer =
        Answer(session_->requests(), {.client = 1, .seq = ++seq_, .what = what, .fields = fields},
               /*is_controller=*/true);
    asked_[seq_] = fields;
    if (!page::IsLater(answer)) ExpectFitsProtocol(answer);
    return answer;
  }
  /// Expects that a message fits the tables of the protocol.
  void ExpectFitsProtocol(const Json& message) {
    Json request = Json::object();
    if (message["t"] == "reply") request = asked_[message["seq"].get<std::uint32_t>()];
    EXPECT_EQ(page::MisfitOf(message, request.value("do", "")), "") << ToText(message);
  }
  /// To the last request.
  Json LaterAnswer() {
    while (true) {
      for (page::DeferredMessage& deferred : TakeDeferred(session_->requests())) {
        ExpectFitsProtocol(deferred.message);
        latest_[deferred.message["t"].get<std::string>()] = deferred.message;
      }
      const Json& reply = latest_["reply"];
      if (reply.is_object() && reply["seq"] == seq_) return reply;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// One that has to be carried out.
  Json Do(const std::string& text) {
    Json answer = Ask(text);
    EXPECT_TRUE(answer["ok"].get<bool>()) << text << " -> " << ToText(answer);
    EXPECT_EQ(page::MisfitOfRequest(ParseJson(text)), "") << text;
    return answer;
  }
  Json Command(const std::string& text) { return Do(R"({"do":"command","command":)" + text + "}"); }
  /// One that must not be: why.
  std::string Refused(const std::string& text) {
    const Json answer = Ask(text);
    EXPECT_FALSE(answer["ok"].get<bool>()) << text;
    return texts::MessageOf(answer.value("error", Json("")));
  }

  /// Expects that everything the state message refuses is refused for the reason that it gives.
  /// @returns the names of the others.
  std::set<std::string> AllowedNow() {
    std::set<std::string> allowed;
    const Json reasons = State()["allowed"];
    for (const char* kind : {"requests", "commands"}) {
      for (const auto& [name, reason] : reasons[kind].items()) {
        if (reason == true) {
          allowed.insert(name);
          continue;
        }
        const bool is_command = std::string_view(kind) == "commands";
        const Json wanted = {{"do", name}};
        const Json answer =
            AskWith(is_command ? Json{{"do", "command"}, {"command", wanted}} : wanted);
        EXPECT_EQ(answer.value("error", Json("it is carried out")), reason) << name;
      }
    }
    return allowed;
  }
  /// Of commands, whether each would be carried out.
  Json AllowedCommands(const std::string& list) {
    Json requests = Json::array();
    for (const Json& command : ParseJson(list)) {
      requests.push_back({{"do", "command"}, {"command", command}});
    }
    const Json answer = AskWith({{"do", "allowed"}, {"requests", std::move(requests)}});
    EXPECT_TRUE(answer["ok"].get<bool>()) << ToText(answer);
    return answer["allowed"];
  }

  void TickSeconds(double seconds) {
    for (int i = 0; i < seconds * sim::kTicksPerSecond; ++i) TickOnce();
  }
  /// However long a brain is waited for.
  void TickOnce() {
    while (!session_->Tick()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    Take();
  }
  void Take() {
    SessionUpdates updates = session_->TakeUpdates();
    for (Json& message : updates.messages) {
      ExpectFitsProtocol(message);
      latest_[message["t"].get<std::string>()] = message;
      sent_.push_back(std::move(message));
    }
    if (updates.view) ++num_views_;
  }
  /// The last message of a kind, null without one.
  Json Latest(const std::string& kind) {
    Take();
    return latest_[kind];
  }
  Json State() { return Everything().back(); }
  Json Scene() { return Everything().front(); }
  std::vector<Json> Everything() {
    std::vector<Json> all = session_->Everything();
    for (const Json& message : all) ExpectFitsProtocol(message);
    return all;
  }
  Vector3 PositionOf(const std::string& id) {
    const library::DisplayedState view = session_->view();
    const Json scene = Scene();
    for (const Json& object : scene["objects"]) {
      if (object["id"] != id) continue;
      return view.state.poses[object["frame"].get<std::size_t>()].translation() /
             view.meters_per_unit;
    }
    ADD_FAILURE() << "there is no " << id;
    return Vector3::Zero();
  }

  /// With the left hand, from wherever it is.
  void PutAOnB() {
    Command(R"({"do":"grasp","hand":"left","object":"a","point":[0,-2,1]})");
    Command(R"({"do":"move_to","hand":"left","position":[0,-2,4]})");
    TickSeconds(0.7);
    Command(R"({"do":"move_to","hand":"left","position":[3,-2,4]})");
    TickSeconds(0.7);
    Command(R"({"do":"move_to","hand":"left","position":[3,-2,2.01]})");
    TickSeconds(0.7);
    Command(R"({"do":"release","hand":"left"})");
    TickSeconds(0.5);
  }
  void WritePython(const std::string& name, const std::string& text) {
    MakeDirectories(root_ / "brains");
    WriteFile(root_ / "brains" / name, text);
  }

  std::filesystem::path root_;
  std::optional<BackgroundJobs> jobs_{std::in_place};
  std::unique_ptr<Session> session_;
  std::uint32_t seq_ = 0;
  std::map<std::uint32_t, Json> asked_;  ///< by `seq`
  std::vector<Json> sent_;
  std::map<std::string, Json> latest_;
  int num_views_ = 0;
};

}  // namespace smile::studio
