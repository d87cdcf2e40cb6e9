// The parts of Bullet's soft bodies, by Bullet's own headers. A tree of faces, which Bullet updates in every step, took
// half of B1's time in scenes without contact.
#ifdef MORULA_TEST_BULLET
#include "catch.h"
#include "engines/bullet_body.h"
#include "lab.h"

using namespace morula;

TEST_CASE("Bodies carry links, faces and a tree of faces only where something needs them") {
  struct Case {
    Baseline baseline;
    bool contact;
    int cells;
    bool links, tree;
  };
  for (const Case& c : {Case{Baseline::b1, false, 1, false, false}, Case{Baseline::b1, true, 1, false, false},
                        Case{Baseline::b1, false, 2, false, false}, Case{Baseline::b1, true, 2, true, true},
                        Case{Baseline::b2, false, 2, true, false}, Case{Baseline::b2, true, 2, true, true},
                        Case{Baseline::b3, false, 1, true, false}}) {
    CAPTURE(name(c.baseline), c.contact, c.cells);
    BulletScene scene = pressurisedCell(1, c.baseline, 0);
    scene.contact = c.contact;
    scene.cells.resize(static_cast<std::size_t>(c.cells), scene.cells[0]);
    btSoftBodyWorldInfo info;
    const auto body = makeSoftBody(scene, makeTemplate(scene.mesh), scene.cells[0], info);
    CHECK(body->m_nodes.size() == 42);
    CHECK(body->m_links.size() == (c.links ? 120 : 0));
    CHECK(body->m_faces.size() == (c.links ? 80 : 0));
    CHECK(body->m_fdbvt.empty() != c.tree);
    CHECK_FALSE(body->m_bUpdateRtCst);  // otherwise the first step would build a tree
  }
}
#endif
