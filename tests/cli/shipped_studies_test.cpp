// Every sentence of scenarios/policies/README.md is what its command says. The command is put to the values of all
// runs of a study, as golden/policies keeps them; and some of these runs are made again, bit by bit.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"
#include "launch.h"
#include "store/database.h"

using namespace morula::test;
using morula::Database;
using Json = nlohmann::json;

namespace {

const std::string folder = "scenarios/policies/";

std::string sourceFile(const std::string& name) { return std::string(MORULA_SOURCE_DIR) + "/" + name; }

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The lines after `$ morula …` in a block of code, and the text before the block.
struct Answer {
  std::string text;
  std::vector<std::string> command;  // without the program's name
  std::vector<std::string> claims;   // "conditions measure=clone_radius labels.division=longest mean 0.742"
};

std::vector<Answer> answersOf(const std::string& markdown) {
  std::vector<Answer> answers;
  std::istringstream stream(markdown);
  std::string paragraph;
  bool inBlock = false, isAnswer = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inBlock = !inBlock;
      if (!inBlock) paragraph.clear(), isAnswer = false;
      continue;
    }
    if (!inBlock) {
      if (line.starts_with("#") || line.starts_with("|")) paragraph.clear();
      else if (!line.empty()) paragraph += line + ' ';
      continue;
    }
    if (line.starts_with("$ morula study compare ")) {
      auto command = wordsOf(line);
      answers.push_back({paragraph, {command.begin() + 2, command.end()}, {}});
      isAnswer = true;
    } else if (isAnswer) {
      answers.back().claims.push_back(line);
    }
  }
  return answers;
}

/// A number as people read it; texts as they are.
std::string textOf(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// "labels.division" of an object; null if there is no such member.
Json member(const Json& object, const std::string& path) {
  const Json* at = &object;
  std::istringstream stream(path);
  for (std::string key; std::getline(stream, key, '.');) {
    if (!at->is_object() || !at->contains(key)) return {};
    at = &at->at(key);
  }
  return *at;
}

/// The only entry of a list whose members are as the words say, "measure=clone_radius".
Json entryOf(const Json& list, const std::vector<std::string>& words) {
  Json found;
  int count = 0;
  for (const Json& entry : list) {
    const bool fits = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      const auto equals = word.find('=');
      return textOf(member(entry, word.substr(0, equals))) == word.substr(equals + 1);
    });
    if (fits) found = entry, ++count;
  }
  CHECK(count == 1);
  return found;
}

/// As many digits after the point as `like` has.
std::string rounded(double value, const std::string& like) {
  const auto point = like.find('.');
  const int digits = point == like.npos ? 0 : static_cast<int>(like.size() - point - 1);
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  const std::string text = buffer;
  return text.find_first_not_of("-0.") == text.npos && text.front() == '-' ? text.substr(1) : text;
}

/// The merged database of a study, of its values alone.
std::string databaseOf(const TemporaryFolder& temporary, const std::string& study) {
  const std::string file = temporary / (study + ".db");
  if (!std::filesystem::exists(file)) {
    Database db(file, Database::Mode::create, std::chrono::seconds(1));
    db.execute(readWhole(sourceFile("golden/policies/" + study + ".sql")));
  }
  return file;
}

}  // namespace

TEST_CASE("every answer of the shipped studies is what its command says") {
  const TemporaryFolder temporary;
  const auto answers = answersOf(readWhole(sourceFile(folder + "README.md")));
  CHECK(answers.size() >= 10);
  std::map<std::vector<std::string>, Json> said;  // by command
  for (const Answer& answer : answers) {
    INFO(answer.text);
    REQUIRE(answer.command.size() >= 3);
    REQUIRE(answer.claims.size() >= 1);
    auto command = answer.command;
    command[2] = databaseOf(temporary, command[2].substr(0, command[2].find('/')));
    if (!said.contains(command)) {
      const auto run = launch(command);
      INFO(run.err);
      REQUIRE(run.code == 0);
      said.emplace(command, Json::parse(run.out));
    }
    for (const std::string& claim : answer.claims) {
      INFO(claim);
      auto words = wordsOf(claim);
      REQUIRE(words.size() >= 4);
      const std::string number = words.back(), field = words[words.size() - 2];
      const Json entry = entryOf(said.at(command).at(words[0]), {words.begin() + 1, words.end() - 2});
      const Json value = member(entry, field);
      CHECK((value.is_number() ? rounded(value.get<double>(), number) : textOf(value)) == number);
      const std::string plain = number.front() == '-' ? number.substr(1) : number;
      CHECK_THAT(answer.text, ContainsSubstring(plain));
    }
  }
}
