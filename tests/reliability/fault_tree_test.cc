// Fault trees: margins, sets of events that fail them, and mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reliability/fault_tree.h"

namespace upbead {
namespace fault_tree_test {

const std::vector<std::string> events{"a", "b", "c"};

SystemNode any(const std::vector<std::string>& names) {
  SystemNode node;
  node.any = NameList(names.begin(), names.end());
  return node;
}

SystemNode all(const std::vector<std::string>& names) {
  SystemNode node;
  node.all = NameList(names.begin(), names.end());
  return node;
}

TEST(FaultTree, TakesTheLeastOfAnyAndTheLargestOfAll) {
  const FaultTree tree({{"top", any({"a", "both"})}, {"both", all({"b", "c"})}}, "top", events);
  EXPECT_EQ(tree.margin({3., 1., 2.}), 2.);
  EXPECT_EQ(tree.margin({-1., 1., 2.}), -1.);
  EXPECT_EQ(tree.margin({3., -1., -2.}), -1.);
}

TEST(FaultTree, HasCutSetsWithoutThoseThatContainAnother) {
  using Sets = std::vector<std::vector<std::size_t>>;
  const FaultTree tree({{"top", any({"a", "both"})}, {"both", all({"b", "c"})}}, "top", events);
  EXPECT_EQ(tree.cut_sets(), (Sets{{0}, {1, 2}}));
  const FaultTree absorbed({{"top", all({"a", "one"})}, {"one", any({"a", "b"})}}, "top", events);
  EXPECT_EQ(absorbed.cut_sets(), (Sets{{0}}));
}

TEST(FaultTree, TellsMistakesWithTheirGate) {
  const auto only = [](const std::map<std::string, SystemNode>& gates) {
    const Diagnostics found = diagnose(gates, events);
    return found.empty() ? std::string() : found.list().front().place.key + ": " + found.list().front().what;
  };
  EXPECT_EQ(only({{"top", any({"a", "b"})}}), "");
  EXPECT_EQ(only({{"top", any({"a", "d"})}}), "top: there is no limit state or gate 'd'");
  EXPECT_EQ(only({{"top", SystemNode()}}), "top: neither 'any' nor 'all' is given");
  EXPECT_EQ(only({{"a", any({"b"})}}), "a: a limit state has that name");
  EXPECT_EQ(only({{"one", any({"a"})}, {"two", all({"b", "c"})}}),
            "two: gates one, two are each part of no other, and which stands for the whole is not said");
  EXPECT_EQ(only({{"one", any({"a"})}, {"two", all({"b", "c"})}, {"whole", any({"one", "two"})}}), "");
  EXPECT_EQ(only({{"x", any({"y"})}, {"y", all({"x", "a"})}}), "x: the gate 'x' is part of itself");
}

}  // namespace fault_tree_test
}  // namespace upbead
