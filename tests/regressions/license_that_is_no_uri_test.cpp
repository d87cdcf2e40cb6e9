// `export --license CC-BY` wrote {"@id": "CC-BY"}, which is no URI. Now SPDX identifiers become their address,
// addresses stay, and other texts are refused with a suggestion.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("export: a licence is an SPDX identifier or a URI") {
  const TemporaryFolder folder;
  const std::string file = folder / "small.yaml", db = folder / "run.db", crate = folder / "crate";
  writeWhole(file, "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1}\n");
  succeeds({"run", file, "--db", db, "--no-pictures", "--out", folder / "out"});
  const std::string cc = "https://spdx.org/licenses/CC-BY-4.0";
  for (const auto& [given, uri] : {std::pair<std::string, std::string>{"CC-BY-4.0", cc},
                                   {"cc-by-4.0", cc},
                                   {"MIT", "https://spdx.org/licenses/MIT"},
                                   {"https://example.org/mine", "https://example.org/mine"}}) {
    std::filesystem::remove_all(crate);
    succeeds({"export", db, "--ro-crate", crate, "--license", given});
    const Json json = Json::parse(readWhole(crate + "/ro-crate-metadata.json"));
    for (const auto& entity : json["@graph"])
      if (entity["@id"] == "./") CHECK(entity["license"]["@id"] == uri);
  }
  std::filesystem::remove_all(crate);
  for (const auto& [given, meant] : {std::pair<std::string, std::string>{"CC-BY", "did you mean CC-BY-4.0?"},
                                     {"CC-BY-SA-4", "did you mean CC-BY-SA-4.0?"},
                                     {"Apache", "did you mean Apache-2.0?"},
                                     {"mine", "is no SPDX identifier"}}) {
    refuses({"export", db, "--ro-crate", crate, "--license", given}, 2, meant);
    CHECK_FALSE(std::filesystem::exists(crate));
  }
}
