// B3: Bullet's deformable world, whose springs are linear like ours, and are solved implicitly.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include "base/error.h"
#include "engines/bullet_body.h"

namespace morula {
namespace {

/// The contents' pressure and the medium's drag, which Bullet lacks. The solver takes both as constant within a step,
/// which is exact at rest.
class ContentsForce final : public btDeformableLagrangianForce {
 public:
  explicit ContentsForce(const BulletScene& scene) : scene_(scene) {}

  void addScaledForces(btScalar scale, TVStack& force) override {
    for (int i = 0; i < m_softBodies.size(); ++i) {
      addPressure(*m_softBodies[i], scene_.cells[static_cast<std::size_t>(i)].pressureConstant, scale, force);
      addDrag(*m_softBodies[i], scale, force);
    }
  }
  void addScaledExplicitForce(btScalar scale, TVStack& force) override { addScaledForces(scale, force); }
  void addScaledDampingForce(btScalar, TVStack&) override {}
  void addScaledElasticForceDifferential(btScalar, const TVStack&, TVStack&) override {}
  void addScaledDampingForceDifferential(btScalar, const TVStack&, TVStack&) override {}
  void buildDampingForceDifferentialDiagonal(btScalar, TVStack&) override {}
  /// Returns a kind that Bullet does not have: it takes forces of one kind for one force.
  btDeformableLagrangianForceType getForceType() override { return static_cast<btDeformableLagrangianForceType>(100); }

 private:
  /// Adds f = P Σ A/3 over the faces of a vertex: a sixth of the cross product of two edges each [Nilsson 2008, eq.
  /// 4.5]. m_q is a node's position in the solver during the step.
  void addPressure(const btSoftBody& body, double constant, btScalar scale, TVStack& force) const {
    double volume = 0;
    for (int f = 0; f < body.m_faces.size(); ++f) {
      const auto& n = body.m_faces[f].m_n;
      volume += n[0]->m_q.dot(n[1]->m_q.cross(n[2]->m_q)) / 6;
    }
    const double pressure = constant / volume - scene_.physics.pressure.outside;
    for (int f = 0; f < body.m_faces.size(); ++f) {
      const auto& n = body.m_faces[f].m_n;
      const btVector3 third = (n[1]->m_q - n[0]->m_q).cross(n[2]->m_q - n[0]->m_q) * (scale * pressure / 6);
      for (const btSoftBody::Node* node : n) force[node->index] += third;
    }
  }
  void addDrag(const btSoftBody& body, btScalar scale, TVStack& force) const {
    for (int v = 0; v < body.m_nodes.size(); ++v) {
      const btSoftBody::Node& node = body.m_nodes[v];
      force[node.index] -= node.m_v * (scale * scene_.physics.drag / node.m_im);
    }
  }

  const BulletScene& scene_;
};

/// Returns k_d of the first cell's springs: Bullet has one damping for all.
double springDamping(const BulletScene& scene) {
  const MembraneParameters& membrane = scene.physics.membrane;
  const double vertices = static_cast<double>(scene.mesh.vertices.size());
  return membrane.damping.of(membrane.stiffness, scene.cells.empty() ? 0 : scene.cells[0].mass / vertices);
}

struct ImplicitWorld final : BulletWorld {
  BulletScene scene;
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btDeformableBodySolver deformables;
  btDeformableMultiBodyConstraintSolver constraints;
  btDeformableMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &constraints, &configuration, &deformables};
  btDeformableMassSpringForce springs;
  ContentsForce contents{scene};
  std::vector<std::unique_ptr<btSoftBody>> bodies;

  explicit ImplicitWorld(const BulletScene& asked)
      : scene(asked), springs(asked.physics.membrane.stiffness, springDamping(asked), true) {
    MORULA_CHECK(!scene.contact && !scene.physics.shell, "B3 has neither contact nor shell");
    constraints.setDeformableSolver(&deformables);
    world.setGravity({0, 0, 0});
    world.setImplicit(true);
    world.setUseProjection(true);
    makeWeightless(world.getWorldInfo(), broadphase, dispatcher);
    checkPrecision(scene.mesh, world.getWorldInfo());
    const MeshTemplate mesh = makeTemplate(scene.mesh);
    for (const Body& cell : scene.cells) {
      bodies.push_back(makeSoftBody(scene, mesh, cell, world.getWorldInfo()));
      world.addSoftBody(bodies.back().get());
      world.addForce(bodies.back().get(), &springs);
      world.addForce(bodies.back().get(), &contents);
    }
  }
  ~ImplicitWorld() override {
    for (auto& body : bodies) world.removeSoftBody(body.get());
  }

  void step() override { world.stepSimulation(scene.timeStep, 0); }
  std::vector<Body> cells() override { return readCells(scene, bodies); }
};

}  // namespace

std::unique_ptr<BulletWorld> makeImplicitWorld(const BulletScene& scene) {
  return std::make_unique<ImplicitWorld>(scene);
}

}  // namespace morula
