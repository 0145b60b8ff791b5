#include <catch2/catch.hpp>

#include "sim/forest/forest.h"

using namespace honka::sim;

TEST_CASE("the default stand holds the paper's number of trees") {
  const ForestSettings settings;
  const Stand stand = make_stand(settings, {}, 1);
  CHECK(stand.trees.size() == 2202);
  for (const Tree& tree : stand.trees) {
    CHECK(stand.extent_m.contains(tree.base_m.head<2>().eval()));
  }
}
