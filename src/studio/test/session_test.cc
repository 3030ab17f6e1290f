// Wrong and hostile requests to a session. What it does is tested in the other files session_*.

#include "studio/session.h"

#include <random>

#include "session_fixture.h"

namespace smile::studio {
namespace {

class SessionTest : public SessionFixture {};

TEST_F(SessionTest, WrongRequestsNameTheField) {
  Begin();
  EXPECT_EQ(Refused(R"({"do":"spawn","preset":"ball","seed":"7"})"),
            "\"seed\" is text, expected a number");
  EXPECT_EQ(Refused(R"({"do":"speed"})"), "\"factor\" is missing, expected a number from 0.1 to 4");
  EXPECT_EQ(Refused(R"({"do":"speed","factor":1e300})"),
            "\"factor\" is 1e+300, expected a number from 0.1 to 4");
  EXPECT_EQ(Refused(R"({"do":"snap","to":"faces"})"),
            "\"to\" is text, expected a list of any of rails, faces, edges, grid or angles");
  EXPECT_NE(Refused(R"({"do":"command","command":{"do":"grasp","hand":"left"}})").find("object"),
            std::string::npos);
}

/// JSON that no client would send, made of the parts of requests.
Json RandomJson(std::mt19937_64* random, int depth) {
  const auto lot = [random](int count) {
    return static_cast<int>((*random)() % static_cast<unsigned>(count));
  };
  static const std::vector<Json> kLeaves = {nullptr,
                                            true,
                                            -1,
                                            0,
                                            7,
                                            1e308,
                                            -1e-308,
                                            "",
                                            "left",
                                            "a",
                                            "grasp",
                                            "take",
                                            "faces",
                                            "pair",
                                            std::string(5000, 'x'),
                                            "../..",
                                            "\xc3\xa4\n",
                                            18446744073709551615u};
  const int kind = depth > 0 ? lot(4) : 0;
  if (kind < 2) return kLeaves[static_cast<std::size_t>(lot(static_cast<int>(kLeaves.size())))];
  static const std::vector<const char*> kKeys = {
      "do",    "command", "hand",      "object", "position", "scene", "xml",
      "name",  "seed",    "preset",    "rage",   "to",       "rate",  "step",
      "after", "brain",   "recording", "angle",  "factor"};
  Json value = kind == 2 ? Json::array() : Json::object();
  for (int i = lot(5); i > 0; --i) {
    if (kind == 2) {
      value.push_back(RandomJson(random, depth - 1));
    } else {
      value[kKeys[static_cast<std::size_t>(lot(static_cast<int>(kKeys.size())))]] =
          RandomJson(random, depth - 1);
    }
  }
  return value;
}

TEST_F(SessionTest, NoRequestHowEverStrangeDoesHarm) {
  Begin();
  std::mt19937_64 random(1);
  std::vector<std::string> requests;
  for (const auto& [name, entry] : session_->requests().requests) requests.push_back(name);
  for (int i = 0; i < 3000; ++i) {
    Json fields = Json::object();
    while (fields.size() < 4) {
      const Json more = RandomJson(&random, 3);
      if (more.is_object()) fields.update(more);
      fields["do"] = requests[random() % requests.size()];
      if (random() % 2 == 0) break;
    }
    const Json answer = AskWith(fields);
    ASSERT_EQ(answer["ok"].is_boolean(), true);
    if (i % 10 == 0) session_->Tick();
  }
  Do(R"({"do":"resume"})");
  EXPECT_TRUE(std::filesystem::is_directory(root_ / "scenes"));
}

}  // namespace
}  // namespace smile::studio
