#include "baseline/bullet_world.h"

#include <cmath>

#include "base/error.h"
#include "baseline/bullet_body.h"
#include "mesh/measures.h"
#include "physics/stages.h"

namespace morula {

namespace {

Point fromBullet(const btVector3& a) { return {a.x(), a.y(), a.z()}; }

/// The core's bodies serve as the notebook in which Bullet's nodes are read: forces and the shell are then
/// the core's own code, the same on both sides of a comparison.
Bodies makeNotebook(const BulletScene& scene) {
  Bodies bodies = makeBodies(scene.physics, scene.mesh, 1);
  setBodies(bodies, scene.cells);
  return bodies;
}

}  // namespace

struct BulletWorld::State {
  BulletScene scene;
  Bodies notebook;
  PhysicsStages forces{}, shell{};  // one without a shell, one for its sake

  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btSoftBody>> bodies;

  explicit State(const BulletScene& asked) : scene(asked), notebook(makeNotebook(asked)) {
    // The thesis' Verlet, for its prediction of the velocity is the velocity itself, as Bullet's.
    scene.physics.integrator = Integrator::thesisVerlet;
    PhysicsParameters open = scene.physics;
    open.shell.reset();
    forces = chooseStages(open, bestIsa());
    shell = chooseStages(scene.physics, bestIsa());
    world.setGravity({0, 0, 0});
    btSoftBodyWorldInfo& info = world.getWorldInfo();
    info.m_gravity.setZero();
    info.air_density = info.water_density = info.water_offset = 0;
    info.m_broadphase = &broadphase;
    info.m_dispatcher = &dispatcher;
    info.m_sparsesdf.Initialize();
    for (const Body& cell : scene.cells) {
      bodies.push_back(makeSoftBody(scene, notebook.mesh, cell, info));
      world.addSoftBody(bodies.back().get());
    }
    checkPrecision();
  }
  ~State() {
    for (auto& body : bodies) world.removeSoftBody(body.get());
  }

  void checkPrecision() const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const double ours = measureVolume(scene.cells[i].position, scene.mesh.faces);
      CHECK(std::abs(volumeOf(*bodies[i]) - ours) <= 1e-12 * ours,
            "Bullet's library measures another volume: is it of another precision than its headers?");
    }
  }

  template <class Visit>  // visit(node, where it stands in position, velocity and acceleration)
  void eachNode(const Visit& visit) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int v = 0; v < notebook.vertexCount(); ++v)
        visit(bodies[i]->m_nodes[v], notebook.at(static_cast<int>(i), v));
  }
  static btVector3 read(const Reals& array, std::size_t at) {
    return {array[at], array[at + blockLanes], array[at + 2 * blockLanes]};
  }
  static void write(Reals& array, std::size_t at, const btVector3& a) {
    array[at] = a.x(), array[at + blockLanes] = a.y(), array[at + 2 * blockLanes] = a.z();
  }

  void addOurForces() {
    for (int i = 0; i < notebook.blockCount(); ++i) advance(forces, notebook, notebook.block(i, 0), 0);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int v = 0; v < notebook.vertexCount(); ++v)
        bodies[i]->addForce(read(notebook.acceleration, notebook.at(static_cast<int>(i), v)), v);
  }

  /// Bullet has no contact on the inside of a shell: the core's, at the end of a drift that takes no time.
  void keepAllInShell() {
    for (int i = 0; i < notebook.blockCount(); ++i)
      shell.drift(notebook.mesh.view(), notebook.block(i, 0), notebook.kernelParameters, 0);
    eachNode([&](btSoftBody::Node& node, std::size_t at) {
      node.m_x = read(notebook.position, at);
      node.m_v = read(notebook.velocity, at);
    });
  }
};

BulletWorld::BulletWorld(const BulletScene& scene) : state_(std::make_unique<State>(scene)) {}
BulletWorld::~BulletWorld() = default;

void BulletWorld::step() {
  State& s = *state_;
  if (s.scene.baseline == Baseline::b1) s.addOurForces();
  else
    for (std::size_t i = 0; i < s.bodies.size(); ++i)
      setPressure(*s.bodies[i], s.scene.cells[i].pressureConstant, s.scene.physics.pressure.outside);
  s.world.stepSimulation(s.scene.timeStep, 0);
  if (s.scene.baseline == Baseline::b2 && !s.scene.physics.shell) return;  // nobody reads the notebook
  s.eachNode([&](const btSoftBody::Node& node, std::size_t at) {
    State::write(s.notebook.position, at, node.m_x);
    State::write(s.notebook.velocity, at, node.m_v);
  });
  if (s.scene.physics.shell) s.keepAllInShell();
}

std::vector<Body> BulletWorld::cells() const {
  std::vector<Body> cells = state_->scene.cells;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t v = 0; v < cells[i].position.size(); ++v) {
      const btSoftBody::Node& node = state_->bodies[i]->m_nodes[static_cast<int>(v)];
      cells[i].position[v] = fromBullet(node.m_x);
      cells[i].velocity[v] = fromBullet(node.m_v);
    }
  return cells;
}

bool bulletIsAvailable() { return true; }

}  // namespace morula
