// The program's knowledge of its build.
#include "store/build_info.h"

#include "base/hash.h"
#include "catch.h"
#include "files/read_file.h"
#include "store/machine_info.h"

using namespace morula;

namespace {

bool isHex(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

TEST_CASE("the build is described completely") {
  const BuildInfo& build = buildInfo();
  CHECK_FALSE(build.version.empty());
  CHECK(isHex(build.sources, 32));
  const bool known = build.gitCommit != "unknown";
  CHECK((!known || isHex(build.gitCommit, 40)));
  CHECK((build.gitState == "clean" || build.gitState == "modified" || build.gitState == "unknown"));
  CHECK(known == (build.gitState != "unknown"));
  CHECK_THAT(build.compiler, ContainsSubstring(" "));
  CHECK_THAT(build.flags, ContainsSubstring("-ffp-contract=off"));
  CHECK_THAT(build.target, ContainsSubstring(" "));
  CHECK(isHex(buildId(build), 32));
  std::string before;
  for (const auto& [library, version] : build.libraries) {
    INFO(library << ' ' << version);
    CHECK(before < library);  // sorted by name, each once
    CHECK(version.find_first_of("0123456789") == 0);
    before = library;
  }
  CHECK(build.libraries.size() >= 10);
}

TEST_CASE("the machine is described") {
  CHECK_FALSE(machineInfo().cpu.empty());
  CHECK_THAT(machineInfo().kernel, ContainsSubstring(" "));
  const std::string now = utcNow();
  CHECK(now.size() == 20);
  CHECK(now[4] == '-');
  CHECK(now[10] == 'T');
  CHECK(now.back() == 'Z');
  CHECK(now > "2024");
}

TEST_CASE("the program knows its own file, and how this processor computes") {
  CHECK(isHex(binaryHash(), 32));
  CHECK(binaryHash() == Hasher().addPiece(readFile("/proc/self/exe", std::uint64_t{1} << 30)).digest().text());
  CHECK_THAT(machineInfo().fpEnvironment, ContainsSubstring("nearest, denormals kept"));
  CHECK(machineInfo().features != "");
}

TEST_CASE("an edited tree's diff goes with the program, a clean one has none") {
  CHECK(buildDiff().empty() == (buildInfo().gitState != "modified"));
  if (!buildDiff().empty()) CHECK_THAT(buildDiff(), ContainsSubstring("diff --git "));
  CHECK(buildDiff().size() <= 262144 + 100);
}
