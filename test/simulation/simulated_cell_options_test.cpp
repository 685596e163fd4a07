#include <gtest/gtest.h>

#include "simulated_cell_node.h"

namespace contact_shapelets::simulation {
namespace {

std::string FaultsOf(const std::string& name, const XmlRpc::XmlRpcValue& value) {
  XmlRpc::XmlRpcValue tree;
  tree[name] = value;
  ParameterReader reader(tree);
  ReadSimulatedCellOptions(&reader);
  return reader.Faults();
}

TEST(SimulatedCellOptions, HaveDefaultsWithoutFaults) { EXPECT_EQ(SimulatedCellOptions{}.Faults(), ""); }

TEST(SimulatedCellOptions, NameTheParameterThatIsOutOfRange) {
  EXPECT_NE(FaultsOf("rate", 2000.0).find("rate must be in [30, 1000] Hz"), std::string::npos);
  EXPECT_NE(FaultsOf("period", 5.0).find("period"), std::string::npos);
  EXPECT_NE(FaultsOf("speed", 3.0).find("publish_clock"), std::string::npos);
  EXPECT_NE(FaultsOf("seed", -1).find("seed"), std::string::npos);
}

TEST(SimulatedCellOptions, NameAnOutcomeThatDoesNotExist) {
  const std::string faults = FaultsOf("script", std::string("switched exploded"));
  EXPECT_NE(faults.find("exploded"), std::string::npos);
  EXPECT_NE(faults.find("slipped_off"), std::string::npos);
}

TEST(SimulatedCellOptions, NameAParameterOfAnotherType) {
  EXPECT_NE(FaultsOf("rate", std::string("fast")).find("rate must be a number"), std::string::npos);
}

}  // namespace
}  // namespace contact_shapelets::simulation
