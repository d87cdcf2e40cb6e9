// When the last cells died while they touched, the list of contacts was still that of the step before. The last sample
// read freed memory, and the program ended with signal 11. Now the list is empty, and the run is done.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("cells that die all at once while they touch end the run, by either law, as meshes and as balls") {
  for (const char* const physics : {"contact: {}", "contact: {law: thesis}", "contact: {}, cell: {model: sphere}"}) {
    const auto run =
        runText(std::string("morula: 1\nname: all-die\ndna: |\n  START: a\n  g1(die|a)\n"
                            "cells: [{at: [-0.9, 0, 0]}, {at: [0.9, 0, 0]}, {at: [0, 1.6, 0]}]\nstop: {time: 3}\n"
                            "record: {every: 0.1, measures: [energy]}\nphysics: {drag: 2, mesh: {icosphere: 1}, ") +
                physics + "}\n");
    CAPTURE(physics);
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(run.out.find("0 cells at time 1") != std::string::npos);
  }
}
