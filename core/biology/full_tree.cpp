#include "biology/full_tree.h"

#include <bit>

#include "base/error.h"

namespace morula {
namespace {

// Nodes are numbered by rows, as in a heap: the egg is 1, the daughters of n are 2n (A) and 2n + 1 (B).
using Node = unsigned;

bool isB(Node node) { return node & 1; }
int depth(Node node) { return std::bit_width(node) - 1; }

std::string substanceOf(Node node) {
  switch (node) {
    case 1: return "P0";
    case 2: return "AB";
    case 3: return "P1";
    case 6: return "EMS";
    case 7: return "P2";
  }
  return substanceOf(node / 2) + (isB(node) ? "b" : "a");
}

/// The inputs by which a cell becomes this node in its next cycle: its mother's substance and its own asymmetry.
std::string cause(Node node) { return node == 1 ? "egg" : substanceOf(node / 2) + ", " + (isB(node) ? "B" : "A"); }

std::string gene(const std::string& name, Node node, const std::string& product, const std::string& inputs) {
  return name + std::to_string(node) + "(" + product + "|" + inputs + ")\n";
}

}  // namespace

std::string makeFullTreeDna(int levels) {
  if (levels < 1 || levels > 16)
    throw InputError("levels: " + std::to_string(levels) + " divisions; give 1 to 16 (16: 65536 final cells)");
  const Node firstFinal = Node{1} << levels;
  const std::string inner = std::to_string(firstFinal - 1), finals = std::to_string(firstFinal);
  std::string text = "# A complete lineage tree of " + std::to_string(levels) + " divisions, " + finals +
                     " unique final cells [Nilsson 2008, 5.2.3]:\n# " + inner + " + " + inner + " + " + finals + " + " +
                     finals + " = " + std::to_string(4 * firstFinal - 2) +
                     " genes. Written by: morula init --dna full-tree --levels " + std::to_string(levels) + "\n" +
                     "START: egg\n";
  for (Node node = 1; node < firstFinal; ++node) {
    if (node == Node{1} << depth(node)) text += "\n# Division " + std::to_string(depth(node) + 1) + "\n";
    text += gene("g", node, substanceOf(node), cause(node));
    text += gene("gd", node, "divide", cause(node));
  }
  text += "\n# Transition to final state, and final state\n";
  for (Node node = firstFinal; node < 2 * firstFinal; ++node) {
    text += gene("g", node, substanceOf(node), cause(node));
    text += gene("gfinal", node, substanceOf(node), substanceOf(node));
  }
  return text;
}

}  // namespace morula
