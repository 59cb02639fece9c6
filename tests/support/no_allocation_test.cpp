#include "tests/support/no_allocation.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

using rob::test::NoAllocation;

namespace {

/// What is written here has escaped, so that the compiler cannot leave the allocation out.
void* volatile escaped = nullptr;

constexpr int kOnce = NoAllocation::kActive ? 1 : 0;

struct alignas(64) CacheLine {
  char bytes[64];
};

}  // namespace

TEST_CASE("arithmetic on the stack takes no memory") {
  const NoAllocation guard;
  Eigen::Vector3d v(1, 2, 3);
  v = 2 * v + Eigen::Vector3d::Ones();
  CHECK(v.z() == 7);
  CHECK(guard.count() == 0);
}

TEST_CASE("a malloc is noticed") {
  const NoAllocation guard;
  escaped = std::malloc(24);
  CHECK(guard.count() == kOnce);
  std::free(escaped);
}

TEST_CASE("a calloc is noticed, also one that the compiler makes of malloc and memset") {
  const NoAllocation guard;
  escaped = std::calloc(3, 8);
  CHECK(guard.count() == kOnce);
  std::free(escaped);
  void* const cleared = std::malloc(4096);
  REQUIRE(cleared != nullptr);
  std::memset(cleared, 0, 4096);
  escaped = cleared;
  CHECK(guard.count() == 2 * kOnce);
  std::free(escaped);
}

TEST_CASE("a realloc is noticed") {
  escaped = std::malloc(8);
  const NoAllocation guard;
  escaped = std::realloc(escaped, 100'000);
  CHECK(guard.count() == kOnce);
  std::free(escaped);
}

TEST_CASE("aligned memory is noticed") {
  const NoAllocation guard;
  escaped = std::aligned_alloc(64, 128);
  CHECK(guard.count() == kOnce);
  std::free(escaped);
  void* block = nullptr;
  REQUIRE(posix_memalign(&block, 32, 100) == 0);
  CHECK(reinterpret_cast<std::uintptr_t>(block) % 32 == 0);
  CHECK(guard.count() == 2 * kOnce);
  std::free(block);
}

TEST_CASE("operator new is noticed, plain and aligned") {
  const NoAllocation guard;
  int* const number = new int(5);
  escaped = number;
  CHECK(guard.count() == kOnce);
  CacheLine* const line = new CacheLine();
  escaped = line;
  CHECK(guard.count() == 2 * kOnce);
  delete line;
  delete number;
}

TEST_CASE("a growing std::vector is noticed, one with room is not") {
  std::vector<double> numbers;
  numbers.reserve(2);
  const NoAllocation guard;
  numbers.push_back(1);
  numbers.push_back(2);
  CHECK(guard.count() == 0);
  numbers.push_back(3);
  CHECK(guard.count() == kOnce);
}

TEST_CASE("an Eigen::VectorXd is noticed") {
  const NoAllocation guard;
  const Eigen::VectorXd v = Eigen::VectorXd::Ones(6);
  CHECK(v.sum() == 6);
  CHECK(guard.count() >= kOnce);
  CHECK((guard.count() > 0) == NoAllocation::kActive);
}

TEST_CASE("memory that another thread takes is not counted") {
  std::unique_ptr<int> theirs;
  int counted_there = -1;
  std::thread other([&] {
    const NoAllocation guard;
    theirs = std::make_unique<int>(1);
    counted_there = guard.count();
  });
  const NoAllocation guard;
  other.join();
  CHECK(guard.count() == 0);
  CHECK(counted_there == kOnce);
}

TEST_CASE("a guard inside another counts for itself") {
  const NoAllocation outer;
  escaped = std::malloc(1);
  std::free(escaped);
  const NoAllocation inner;
  escaped = std::malloc(1);
  std::free(escaped);
  CHECK(inner.count() == kOnce);
  CHECK(outer.count() == 2 * kOnce);
}
