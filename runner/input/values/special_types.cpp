// Parameters that are one of a kind: DNA, the time step, the shell's spellings, the size at division.
#include "values/value_types.h"

namespace morula::scenario {

Parameter dna() {
  Parameter p;
  p.path = "dna";
  p.allowed = "DNA text after '|', or {file: name.dna}";
  p.meaning =
      "The organism's genes in the thesis' syntax: START: a0 and lines g1(a1|a0, A); a line with a range, as "
      "g{n}(a{n+1}|a{n}) for n in 0..4, is one gene for each number";
  p.required = true;
  p.schema = {
      {"oneOf", Json::array({{{"type", "string"}}, onlySchema("file", {{"type", "string"}, {"minLength", 1}})})}};
  p.read = [allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    reading.dna.place = node.place;
    if (node.kind == Node::Kind::map) {
      const auto* file = readOnly(node, "dna", {"file"}, allowed, reading.problems);
      if (!file) return;
      reading.dna.place = file->value.place;
      if (file->value.kind == Node::Kind::scalar && !file->value.text.empty()) reading.dna.file = file->value.text;
      else if (file->value.kind != Node::Kind::broken)
        reading.problems.add(file->value.place, "dna.file", "is " + describe(file->value), "needs a file name");
    } else if (node.kind == Node::Kind::scalar) {
      // Folding joins lines, and a line is a gene.
      if (node.style == '>')
        reading.problems.add(node.place, "dna", "'>' joins the lines", "write '|', which keeps them");
      else reading.dna.text = node;
    } else {
      refuse(node, "dna", allowed, reading.problems);
    }
  };
  p.write = [](const Scenario& s) {
    const auto& dna = s.scene.dna;
    if (dna.substances.empty()) return Json();
    const auto list = [&](const std::vector<SubstanceId>& ids, const std::vector<SubstanceId>& repressors = {}) {
      std::string text;
      for (const auto id : ids) text += (text.empty() ? "" : ", ") + dna.substances[id];
      for (const auto id : repressors) text += ", !" + dna.substances[id];
      return text;
    };
    std::string text = "START: " + list(dna.start) + "\n";
    for (const auto& gene : dna.genes)
      text += gene.name + "(" + dna.substances[gene.product] + "|" + list(gene.inputs, gene.repressors) + ")\n";
    return Json(text);
  };
  return p;
}

Parameter divisionSize() {
  Parameter p;
  p.path = "division.size";
  p.allowed = "timer, {sizer: 0.8}, or {adder: 0.3}, with any number > 0";
  p.meaning =
      "Size at which a cell may divide, as its volume at rest over the egg's: any size when its cycle is due "
      "(timer), from this size on (sizer), or after gaining this size since its birth (adder). A cell whose due "
      "cycle would make it divide waits for its size; needs growth";
  p.later = true;
  p.absent = "timer";
  Json forms = Json::array({{{"const", "timer"}}});
  for (const char* rule : {"sizer", "adder"}) forms.push_back(onlySchema(rule, numberSchema(positive)));
  p.schema = {{"oneOf", forms}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind == Node::Kind::scalar && node.text == "timer") return;
    if (node.kind != Node::Kind::map) return refuse(node, path, allowed, reading.problems);
    const Member* given = readOnly(node, path, {"sizer", "adder"}, allowed, reading.problems);
    if (!given) return;
    const auto rule = given->key == "sizer" ? DivisionSize::Rule::sizer : DivisionSize::Rule::adder;
    if (const auto size = readMember(node, given->key, positive, "", path, reading.problems))
      s.scene.cycle.divisionSize = DivisionSize{rule, *size};
  };
  p.write = [](const Scenario& s) {
    const auto& size = s.scene.cycle.divisionSize;
    if (!size) return Json();
    return Json{{size->rule == DivisionSize::Rule::sizer ? "sizer" : "adder", size->size}};
  };
  return p;
}

Parameter timeStep() {
  Parameter p;
  p.path = "physics.time_step";
  p.unit = "time";
  p.allowed = numberAllowed(positive, p.unit) + ", auto, or {auto: 0.5}";
  p.meaning =
      "Length of a time step; shorter steps are more exact and slower. auto: powers of two below the stability "
      "limits, which fall as cells halve; {auto: 0.5}: steps half as long, with any share > 0 and ≤ 1";
  p.absent = "auto";
  const Range share{0, 1, true};
  p.schema = {
      {"oneOf", Json::array({numberSchema(positive), {{"const", "auto"}}, onlySchema("auto", numberSchema(share))})}};
  p.read = [path = p.path, allowed = p.allowed, share](Scenario& s, const Node& node, Reading& reading) {
    auto& physics = s.scene.mechanics->physics;
    if (node.kind == Node::Kind::map) {
      if (!readOnly(node, path, {"auto"}, allowed, reading.problems)) return;
      if (const auto value = readMember(node, "auto", share, "", path, reading.problems))
        physics.timeStep = std::nullopt, physics.autoShare = *value;
    } else if (node.kind == Node::Kind::scalar && node.text == "auto") {
      physics.timeStep = std::nullopt, physics.autoShare = 1;
    } else if (const auto value = readReal(node, positive, path, allowed, reading.problems)) {
      physics.timeStep = *value, physics.autoShare = 1;
    }
  };
  p.write = [](const Scenario& s) {
    const auto& physics = s.scene.mechanics->physics;
    if (physics.timeStep) return Json(*physics.timeStep);
    return physics.autoShare == 1 ? Json("auto") : Json{{"auto", physics.autoShare}};
  };
  return p;
}

Parameter damping(const char* path, const char* meaning, Field<Damping> at) {
  Parameter p;
  p.path = path;
  p.unit = "force·time/length";
  p.allowed = numberAllowed(notNegative, p.unit) + ", or {ratio: 0.1}, with any number > 0";
  p.meaning =
      meaning + std::string(
                    "; {ratio: 0.1}: a tenth of critical damping, 2 √(stiffness × mass of a vertex), which follows "
                    "masses, so that small cells do not need short time steps");
  p.schema = {{"oneOf", Json::array({numberSchema(notNegative), onlySchema("ratio", numberSchema(positive))})}};
  p.read = [path = p.path, allowed = p.allowed, at](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind != Node::Kind::map) {
      if (const auto value = readReal(node, notNegative, path, allowed, reading.problems)) at(s) = *value;
    } else if (readOnly(node, path, {"ratio"}, allowed, reading.problems)) {
      if (const auto ratio = readMember(node, "ratio", positive, "", path, reading.problems)) at(s).ratio = *ratio;
    }
  };
  p.write = [at](const Scenario& s) {
    const Damping& damping = at(const_cast<Scenario&>(s));
    return damping.ratio > 0 ? Json{{"ratio", damping.ratio}} : Json(damping.constant);
  };
  return p;
}

Parameter shellSphere() {
  auto p = real("physics.shell.sphere", "length", positive, "Radius of a sphere about the origin", nullptr);
  p.absent = "see ellipsoid";
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (const auto radius = readReal(node, positive, path, allowed, reading.problems))
      for (double& axis : s.scene.mechanics->physics.shell->semiAxes) axis = *radius;
  };
  p.write = [](const Scenario& s) {
    if (s.shellMesh) return Json();
    const auto& axes = s.scene.mechanics->physics.shell->semiAxes;
    return axes[0] == axes[1] && axes[1] == axes[2] ? Json(axes[0]) : Json();
  };
  return p;
}

Parameter shellEllipsoid() {
  auto p = real("physics.shell.ellipsoid", "length", positive, "Semi-axes along x, y and z of an ellipsoid", nullptr);
  p.allowed = "three numbers > 0 [length], as [27, 15, 11]";
  p.absent = "see sphere";
  p.schema = listSchema(p.schema, 3);
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto axes = readTriple(node, positive, path, allowed, reading.problems);
    if (!axes) return;
    double* shell = s.scene.mechanics->physics.shell->semiAxes.data();
    shell[0] = axes->x, shell[1] = axes->y, shell[2] = axes->z;
  };
  p.write = [](const Scenario& s) {
    const auto& axes = s.scene.mechanics->physics.shell->semiAxes;
    return axes[0] == axes[1] && axes[1] == axes[2] ? Json() : Json{axes[0], axes[1], axes[2]};
  };
  return p;
}

Parameter shellMesh() {
  auto p = optionalFile(
      "physics.shell.mesh",
      "Wavefront OBJ of a closed, convex surface around the origin, in lengths of the scene; the shell is the space "
      "inside of all its faces",
      [](Scenario & s) -> auto& { return s.shellMesh; });
  p.absent = "see sphere";
  p.later = true;
  return p;
}

Parameter shellFill() {
  const Range share{0, 1, true};
  auto p = real("physics.shell.fill", "", share,
                "Share of the shell's volume that the egg fills: sphere, ellipsoid or mesh (a sphere if none is "
                "given) then give the shell's shape alone, and its size follows; in an ellipsoid the egg starts "
                "with the shell's shape",
                nullptr);
  p.absent = "sizes are as given, and the egg is round";
  p.joins = true;
  p.later = true;
  p.read = [path = p.path, allowed = p.allowed, share](Scenario& s, const Node& node, Reading& reading) {
    if (const auto fill = readReal(node, share, path, allowed, reading.problems)) s.shellFill = *fill;
  };
  p.write = [](const Scenario& s) { return s.shellFill ? Json(*s.shellFill) : Json(); };
  return p;
}

}  // namespace morula::scenario
