// A steady step allocates nothing. The operators below count for this whole program.
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "catch.h"
#include "worlds.h"

namespace {

std::atomic<std::uint64_t> allocations = 0;
std::atomic<std::int64_t> bytesInUse = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* p = alignment <= alignof(std::max_align_t) ? std::malloc(size) : std::aligned_alloc(alignment, whole);
  if (p == nullptr) throw std::bad_alloc();
  bytesInUse += static_cast<std::int64_t>(malloc_usable_size(p));
  return p;
}

void release(void* p) {
  bytesInUse -= static_cast<std::int64_t>(malloc_usable_size(p));
  std::free(p);
}

}  // namespace

#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // sees malloc behind new and free behind delete

// All other forms in the standard library call these; the address sanitizer's do not, hence nothrow.
void* operator new(std::size_t size) { return counted(size, 1); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t line) { return counted(size, static_cast<std::size_t>(line)); }
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

using namespace morula;

namespace {

std::uint64_t allocationsOf(World& world, int steps) {
  const std::uint64_t before = allocations;
  for (int i = 0; i < steps; ++i) step(world);
  return allocations - before;
}

Scene crowdedScene() {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
  scene.mechanics->physics.drag = 2;
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  scene.mechanics->physics.growth = GrowthParameters{0.01};
  scene.mechanics->connections = ConnectionParameters{MakeConnections::both, ConnectionsOnDivision::both, 0.2, 3.0};
  return scene;
}

/// Returns a world of seventeen cells that touch, come to rest, are connected and grow.
World crowd(const Scene& scene, int threads, const SearchSettings& search = {}) {
  World world = worldOf(scene, flyingCells(scene.mechanics->mesh, 17, 2, 0.1), {bestIsa(), threads, search});
  if (world.connections) connect(*world.connections, world.cells.path[0], world.cells.path[1], 0);
  world.cells.growth[3] = 1;
  return world;
}

}  // namespace

TEST_CASE("The counter counts") {
  const std::uint64_t before = allocations;
  std::vector<int> some(10);
  AlignedVector<double> aligned(10);
  CHECK(allocations == before + 2);
}

TEST_CASE("A steady step allocates nothing, with contact, connections and growth, on one thread") {
  World world = crowd(crowdedScene(), 1);
  allocationsOf(world, 2000);  // to rest
  CHECK(allocationsOf(world, 200) == 0);
}

TEST_CASE("A step that builds the neighbour list anew allocates nothing, once there is room") {
  for (ContactSearch search : valuesOf<ContactSearch>()) {
    World world = crowd(crowdedScene(), 1, {search, 0.15});
    allocationsOf(world, 4000);
    const auto rebuild = [&] { return world.contacts->listIsValid = false, allocationsOf(world, 1); };
    rebuild(), rebuild();  // makes room for all pairs, which are taken if lists end soon
    const auto rebuilds = world.contacts->rebuilds;
    std::uint64_t count = 0;
    for (int i = 0; i < 50; ++i) count += rebuild();
    CAPTURE(nameOf(search));
    CHECK(world.contacts->rebuilds == rebuilds + 50);
    CHECK(count == 0);
  }
}

TEST_CASE("A hundred thousand steps of a crowd that never rests take no more memory than the first thousands") {
  Scene scene = crowdedScene();
  scene.mechanics->physics.growth.reset();
  scene.mechanics->physics.drag = 0.5;
  scene.mechanics->physics.shell = ShellParameters{{1.8, 1.8, 1.8}};
  World world =
      worldOf(scene, flyingCells(scene.mechanics->mesh, 8, 2, 0.1), {bestIsa(), 1, {ContactSearch::grid, 0.15}});
  Bodies& b = *world.bodies;
  const auto goOn = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      if (i % 500 == 0)  // pushes another cell every 500 steps
        for (int v = 0; v < b.vertexCount(); ++v) {
          const int slot = static_cast<int>(world.clock.step / 500 % 8);
          b.write(b.velocity, slot, v, b.read(b.velocity, slot, v) - 1.5 * measureCentre(b, slot));
        }
      step(world);
    }
  };
  goOn(10'000);
  const std::int64_t early = bytesInUse;
  const auto rebuilds = world.contacts->rebuilds;
  goOn(100'000);
  CHECK(world.contacts->rebuilds > rebuilds + 1000);
  CHECK(bytesInUse <= early + early / 20);  // a list may still become a little longer than any before
}

#if !defined(__SANITIZE_THREAD__)  // ThreadSanitizer runs each loop on new std::threads
TEST_CASE("Threads allocate nothing of ours either; what TBB takes, it takes from itself") {
  for (int threads : {2, 3}) {
    World world = crowd(crowdedScene(), threads);
    allocationsOf(world, 2000);
    CHECK(allocationsOf(world, 200) == 0);
  }
}
#endif

TEST_CASE("Cells with different meshes allocate nothing, nor do searches among them") {
  for (ContactSearch search : valuesOf<ContactSearch>()) {
    const Scene scene = scenes::mixedMeshes();
    World world = worldOf(scene, mixedCells(scene, 17, 2, 0.1), {bestIsa(), 1, {search, 0.15}});
    allocationsOf(world, 2000);  // to rest: until then a list may become longer than any before
    std::uint64_t count = allocationsOf(world, 50);
    for (int i = 0; i < 20; ++i) {
      world.contacts->listIsValid = false;
      count += allocationsOf(world, 1);
    }
    CAPTURE(nameOf(search));
    CHECK(count == 0);
  }
}

TEST_CASE("Bodies without contact or connections, in a shell, allocate nothing") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
  scene.mechanics->physics.shell = ShellParameters{{3, 3, 9}};  // the topmost cell ends at 8
  World world = crowd(scene, 1);
  CHECK(allocationsOf(world, 1) == 0);
  CHECK(allocationsOf(world, 200) == 0);
}
