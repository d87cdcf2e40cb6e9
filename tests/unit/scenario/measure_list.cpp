// Every measure has a row, and every row is documented.
#include "values/measure_list.h"

#include "helpers.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("scenarios/MEASURES.md is current") {
  // After a change run: morula schema --measures --markdown > scenarios/MEASURES.md
  CHECK(readText("scenarios/MEASURES.md") == measuresAsMarkdown());
}

TEST_CASE("The list of measures as JSON holds each row") {
  const auto json = parseJson(measuresAsJson());
  CHECK(json.at("cell").size() == measures<CellContext>().size());
  CHECK(json.at("world").at(0).at("name") == "cells");
  CHECK(json.at("pair").at(0).at("unit") == "length²");
  for (const char* scope : {"world", "cell", "pair"})
    for (const auto& row : json.at(scope)) CHECK(row.at("meaning").get<std::string>().size() > 5);
}
