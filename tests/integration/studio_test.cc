// `smile studio`, as far as it needs no browser.

#include "program.h"

namespace smile {
namespace {

class StudioProgram : public ProgramTest {
 protected:
  /// A page of the test's own, found beside everything else that ships.
  void WritePage() const { Write("build/page/index.html", "<html>the page</html>"); }

  /// Starts the studio with these arguments and, once it is open, runs a line of shell that finds
  /// its $link and $port.
  Answer WhileOpen(const std::string& arguments, const std::string& line) const {
    return Shell("export SMILE_DATA_DIR=\"$PWD\"\n\"" SMILE_PROGRAM "\" studio --no-open " +
                 arguments +
                 " >link 2>said & studio=$!\n"
                 "until [ -s link ] || ! kill -0 $studio; do sleep 0.05; done\n"
                 "link=$(cat link); port=${link#*:*:}; port=${port%%/*}\n"
                 "get() { exec 3<>/dev/tcp/127.0.0.1/$port; printf 'GET %s HTTP/1.1\\r\\nHost: "
                 "localhost\\r\\nConnection: close\\r\\n\\r\\n' \"$1\" >&3; cat <&3; }\n" +
                 line + "\nkill -TERM $studio; wait $studio; code=$?; cat said >&2; exit $code");
  }
};

TEST_F(StudioProgram, ServesItsPageUntilASignal) {
  WritePage();
  Write("pair.xml", PairOfBlocks());
  const Answer answer = WhileOpen("pair.xml --no-robot --no-pictures", "get /");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("<html>the page</html>"), std::string::npos);
}

TEST_F(StudioProgram, AdmitsOthersWithItsToken) {
  WritePage();
  Write("pair.xml", PairOfBlocks());
  const Answer answer = WhileOpen("pair.xml --no-robot --no-pictures --listen 0.0.0.0",
                                  "get /; get \"/?token=${link#*token=}\"");
  EXPECT_EQ(answer.out.substr(0, 12), "HTTP/1.1 403");
  EXPECT_NE(answer.out.find("HTTP/1.1 303"), std::string::npos);
}

TEST_F(StudioProgram, ServesItsPageOverTls) {
  WritePage();
  Write("pair.xml", PairOfBlocks());
  Shell(
      "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 "
      "-subj /CN=localhost -addext subjectAltName=DNS:localhost -keyout key.pem -out cert.pem");
  const Answer answer = WhileOpen(
      "pair.xml --no-robot --no-pictures --tls-cert cert.pem --tls-key key.pem",
      "echo \"${link%:*}\"; printf 'GET / HTTP/1.1\\r\\nHost: localhost\\r\\nConnection: "
      "close\\r\\n\\r\\n' | openssl s_client -quiet -connect 127.0.0.1:$port -CAfile cert.pem "
      "-verify_return_error -verify_hostname localhost");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.out.starts_with("https://127.0.0.1\n")) << answer.out;
  EXPECT_NE(answer.out.find("<html>the page</html>"), std::string::npos) << answer.err;
}

TEST_F(StudioProgram, RefusesHalfOfWhatTlsNeeds) {
  WritePage();
  Write("pair.xml", PairOfBlocks());
  Write("cert.pem", "no certificate");
  EXPECT_EQ(Shell("smile studio --no-open --tls-cert cert.pem").exit_code, 2);
  const Answer answer = Shell(
      "export SMILE_DATA_DIR=\"$PWD\"; smile studio --no-open --no-robot --no-pictures "
      "--tls-cert cert.pem --tls-key cert.pem pair.xml");
  EXPECT_NE(answer.exit_code, 0);
  EXPECT_NE(answer.err.find("cert.pem: "), std::string::npos) << answer.err;
}

TEST_F(StudioProgram, ReportsMissingParts) {
  Write("build/page/nothing", "");
  EXPECT_NE(Shell("export SMILE_DATA_DIR=\"$PWD\"; smile studio --no-open")
                .err.find("the studio's page is not built; run ./run studio to build it"),
            std::string::npos);
  WritePage();
  const Answer answer = Shell("export SMILE_DATA_DIR=\"$PWD\"; smile studio nowhere.xml --no-open");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("nowhere.xml"), std::string::npos);
}

}  // namespace
}  // namespace smile
