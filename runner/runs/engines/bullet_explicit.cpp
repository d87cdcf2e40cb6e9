#include "engines/bullet_body.h"
#include "engines/bullet_world.h"
#include "physics/stages.h"

namespace morula {
namespace {

/// Makes bodies of the core, the notebook, into which Bullet's nodes are read. Forces and shell are then computed by
/// the core's own code, as on the other side of a comparison.
Bodies makeNotebook(const BulletScene& scene) {
  Bodies bodies = makeBodies(scene.physics, scene.mesh, 1);
  setBodies(bodies, scene.cells);
  return bodies;
}

struct ExplicitWorld final : BulletWorld {
  BulletScene scene;
  Bodies notebook;                  // for B1, `acceleration` belongs to the present state of the nodes
  PhysicsStages forces{}, shell{};  // stages without the shell, and with it
  bool secondOrder;                 // B1 as velocity Verlet: Bullet's velocities lag by half a step

  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btSoftBody>> bodies;

  explicit ExplicitWorld(const BulletScene& asked)
      : scene(asked),
        notebook(makeNotebook(asked)),
        secondOrder(asked.baseline == Baseline::b1 && asked.physics.integrator != Integrator::thesisVerlet) {
    // With a time step of 0, the drift of thesisVerlet moves nothing, and predicts the present velocity.
    scene.physics.integrator = Integrator::thesisVerlet;
    PhysicsParameters open = scene.physics;
    open.shell.reset();
    const Isa isa = narrowestIsa(notebook.count, bestIsa(), Precision::binary64);
    forces = chooseStages(open, isa);
    shell = chooseStages(scene.physics, isa);
    world.setGravity({0, 0, 0});
    btSoftBodyWorldInfo& info = world.getWorldInfo();
    makeWeightless(info, broadphase, dispatcher);
    checkPrecision(scene.mesh, info);
    for (const Body& cell : scene.cells) {
      bodies.push_back(makeSoftBody(scene, notebook.mesh, cell, info));
      world.addSoftBody(bodies.back().get());
    }
    if (scene.baseline != Baseline::b1) return;
    evaluateForces();
    // Half a step back, so that Bullet's first whole kick ends half a step after the start.
    if (secondOrder) eachNode([&](btSoftBody::Node& node, std::size_t at) { node.m_v -= halfKick(at); });
  }
  ~ExplicitWorld() override {
    for (auto& body : bodies) world.removeSoftBody(body.get());
  }

  template <class Visit>  // visit(node, index in position, velocity and acceleration)
  void eachNode(const Visit& visit) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int v = 0; v < notebook.vertexCount(); ++v)
        visit(bodies[i]->m_nodes[v], notebook.at(static_cast<int>(i), v));
  }
  static btVector3 read(const Reals& array, std::size_t at) {
    return {btScalar(array[at]), btScalar(array[at + blockLanes]), btScalar(array[at + 2 * blockLanes])};
  }
  static void write(Reals& array, std::size_t at, const btVector3& a) {
    array[at] = a.x(), array[at + blockLanes] = a.y(), array[at + 2 * blockLanes] = a.z();
  }
  btVector3 halfKick(std::size_t at) const { return 0.5 * scene.timeStep * read(notebook.acceleration, at); }

  /// Computes accelerations at the notebook's positions and velocities. The shell bears what presses against it.
  void evaluateForces() {
    for (int i = 0; i < notebook.blockCount(); ++i) {
      advance(forces, notebook, notebook.block(i, 0), 0);
      kick(shell, notebook, notebook.block(i, 0), 0);
    }
  }

  /// Applies the core's shell, by a drift that takes no time: Bullet has no contact on the inside of a shell.
  void keepAllInShell() {
    for (int i = 0; i < notebook.blockCount(); ++i)
      shell.drift(notebook.mesh.view(), notebook.block(i, 0), notebook.kernelParameters, 0);
    eachNode([&](btSoftBody::Node& node, std::size_t at) {
      node.m_x = read(notebook.position, at);
      node.m_v = read(notebook.velocity, at);
    });
  }

  void step() override {
    if (scene.baseline == Baseline::b1)
      eachNode(
          [&](btSoftBody::Node& node, std::size_t at) { node.m_f += read(notebook.acceleration, at) / node.m_im; });
    else
      for (std::size_t i = 0; i < bodies.size(); ++i)
        setPressure(*bodies[i], scene.cells[i].pressureConstant, scene.physics.pressure.outside);
    world.stepSimulation(scene.timeStep, 0);
    if (scene.baseline == Baseline::b2 && !scene.physics.shell) return;  // the notebook is not read
    eachNode([&](const btSoftBody::Node& node, std::size_t at) {
      write(notebook.position, at, node.m_x);
      write(notebook.velocity, at, node.m_v);
    });
    if (scene.physics.shell) keepAllInShell();
    if (scene.baseline != Baseline::b1) return;
    // w = v + ½Δt a, with the acceleration of the last step: the velocity at the time of the positions, as velocity
    // Verlet predicts it.
    if (secondOrder)
      eachNode(
          [&](const btSoftBody::Node& node, std::size_t at) { write(notebook.velocity, at, node.m_v + halfKick(at)); });
    evaluateForces();
  }

  std::vector<Body> cells() override {
    std::vector<Body> cells = readCells(scene, bodies);
    if (secondOrder)
      for (std::size_t i = 0; i < cells.size(); ++i)
        for (int v = 0; v < notebook.vertexCount(); ++v) {
          const btVector3 rest = halfKick(notebook.at(static_cast<int>(i), v));
          cells[i].velocity[static_cast<std::size_t>(v)] += {rest.x(), rest.y(), rest.z()};
        }
    return cells;
  }
};

}  // namespace

std::unique_ptr<BulletWorld> makeBulletWorld(const BulletScene& scene) {
  return scene.baseline == Baseline::b3 ? makeImplicitWorld(scene) : std::make_unique<ExplicitWorld>(scene);
}

bool bulletIsAvailable() { return true; }

}  // namespace morula
