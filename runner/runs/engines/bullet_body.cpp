#include "engines/bullet_body.h"

#include <cmath>

#include "base/error.h"
#include "mesh/mesh_measures.h"

namespace morula {
namespace {

btVector3 toBullet(const Point& a) { return {btScalar(a.x), btScalar(a.y), btScalar(a.z)}; }
Point fromBullet(const btVector3& a) { return {a.x(), a.y(), a.z()}; }

void configure(btSoftBody& body, const BulletScene& scene) {
  btSoftBody::Config& c = body.m_cfg;
  c.viterations = c.diterations = c.citerations = 0;
  c.m_psequence.clear();
  c.m_vsequence.clear();
  c.m_dsequence.clear();
  if (scene.touching()) c.m_psequence.push_back(btSoftBody::ePSolver::SContacts);
  if (scene.baseline == Baseline::b2) c.m_psequence.push_back(btSoftBody::ePSolver::Linear);
  c.piterations = c.m_psequence.size() > 0 ? scene.iterations : 0;
  c.collisions = scene.touching() ? btSoftBody::fCollision::VF_SS : 0;
  c.kSHR = 1;  // contacts are resolved wholly in the step that finds them
  c.kDF = 0;   // no friction
  // Bullet removes the share kDP of the velocity in each step. Our drag is −drag·v, which B1 adds as a force.
  c.kDP = scene.baseline == Baseline::b2 ? scene.physics.drag * scene.timeStep : 0;
  body.getCollisionShape()->setMargin(scene.margin);
  body.setActivationState(DISABLE_DEACTIVATION);
}

}  // namespace

std::unique_ptr<btSoftBody> makeSoftBody(const BulletScene& scene, const MeshTemplate& mesh, const Body& cell,
                                         btSoftBodyWorldInfo& info) {
  std::vector<btVector3> places;
  for (const Point& x : cell.position) places.push_back(toBullet(x));
  const double vertexMass = cell.mass / mesh.vertexCount();
  const std::vector<btScalar> masses(places.size(), btScalar(vertexMass));
  auto body = std::make_unique<btSoftBody>(&info, static_cast<int>(places.size()), places.data(), masses.data());
  for (std::size_t v = 0; v < cell.velocity.size(); ++v)
    body->m_nodes[static_cast<int>(v)].m_v = toBullet(cell.velocity[v]);

  configure(*body, scene);
  body->m_bUpdateRtCst = false;                                          // see below
  if (scene.baseline == Baseline::b1 && !scene.touching()) return body;  // only nodes move

  // A link moves its ends by kLST (l² − L0²)/(2 (l² + L0²)) of its length per iteration. n iterations are as stiff as
  // k_s if kLST = k_s Δt² (1/m + 1/m)/n.
  const double dt = scene.timeStep, inverseMasses = 2 / vertexMass;
  btSoftBody::Material* material = body->appendMaterial();
  material->m_kLST = scene.physics.membrane.stiffness * dt * dt * inverseMasses / scene.iterations;
  for (int e = 0; e < mesh.edgeCount(); ++e) body->appendLink(mesh.edges[2 * e], mesh.edges[2 * e + 1], material);
  for (const Face& f : mesh.mesh.faces) body->appendFace(f[0], f[1], f[2], material);

  // After appending, Bullet's next step would take every present length for the rest length. That step is told that all
  // is up to date, and the values that it would have set are set below.
  body->updateConstants();
  body->m_bUpdateRtCst = false;
  for (int e = 0; e < mesh.edgeCount(); ++e) body->m_links[e].m_rl = mesh.restLengths[e] * cell.restScale;
  body->updateLinkConstants();
  for (int e = 0; e < mesh.edgeCount(); ++e) {
    btSoftBody::Link& link = body->m_links[e];
    link.m_c1 = link.m_rl * link.m_rl;
    if (!mesh.springWeights.empty()) link.m_c0 /= mesh.springWeights[e];  // (1/m + 1/m)/kLST
  }
  if (scene.touching()) body->initializeFaceTree();
  body->updateNormals();
  return body;
}

void setPressure(btSoftBody& body, double pressureConstant, double outside) {
  body.updateArea(false);  // else Bullet keeps the areas of the first step
  // (k_p/V − P_0) = (k_p − P_0 V)/V; halved, since Bullet's areas are twice the true ones.
  body.m_cfg.kPR = 0.5 * (pressureConstant - outside * body.getVolume());
}

void makeWeightless(btSoftBodyWorldInfo& info, btBroadphaseInterface& broadphase, btDispatcher& dispatcher) {
  info.m_gravity.setZero();
  info.air_density = info.water_density = info.water_offset = 0;
  info.m_broadphase = &broadphase;
  info.m_dispatcher = &dispatcher;
  info.m_sparsesdf.Initialize();
}

void checkPrecision(const Mesh& egg, btSoftBodyWorldInfo& info) {
  std::vector<btVector3> places;
  for (const Point& x : egg.vertices) places.push_back(toBullet(x));
  btSoftBody body(&info, static_cast<int>(places.size()), places.data(), nullptr);
  for (const Face& f : egg.faces) body.appendFace(f[0], f[1], f[2]);
  const double ours = measureVolume(egg.vertices, egg.faces);
  MORULA_CHECK(std::abs(body.getVolume() - ours) <= 5000 * double(SIMD_EPSILON) * ours,  // double: 1e-12
               "Bullet's library measures another volume: is it of another precision than its headers?");
}

std::vector<Body> readCells(const BulletScene& scene, const std::vector<std::unique_ptr<btSoftBody>>& bodies) {
  std::vector<Body> cells = scene.cells;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t v = 0; v < cells[i].position.size(); ++v) {
      const btSoftBody::Node& node = bodies[i]->m_nodes[static_cast<int>(v)];
      cells[i].position[v] = fromBullet(node.m_x);
      cells[i].velocity[v] = fromBullet(node.m_v);
    }
  return cells;
}

}  // namespace morula
