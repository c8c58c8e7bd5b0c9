// Claims: transfer() is H(s) of the closed form; joining two loads adds their transfer functions and does not change
// other loads.
#include "upbead/dynamics/modal_model.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "modal_models.h"
#include "reduction_tools.h"

namespace modal_model_test {

using namespace upbead;
using namespace upbead::test;
using Complex = std::complex<double>;

TEST(ModalModel, TransferOfAnOscillator) {
  const Oscillator oscillator;
  const ModalModel model = oscillator.model();
  for (const Complex s : {Complex(0., 0.), Complex(0., 20.), Complex(3., -7.), Complex(50., 0.)}) {
    const Complex H = 1. / (oscillator.m * s * s + oscillator.c * s + oscillator.k);
    Eigen::Vector3cd expected(H, s * H, s * s * H);
    // x'' of a mode loses digits to the feedthrough 1/m, which it nearly cancels.
    EXPECT_LT((transfer(model, s == 0. ? Complex(1e-9) : s) - expected).cwiseAbs().maxCoeff(), 1e-8 * std::abs(H)) << s;
  }
}

TEST(ModalModel, JoinsLoads) {
  ModalModel model = random_model(12, 3, 2, 0.1);
  model.load_name = {"a", "b", "c"};
  const Complex s(0.7, 3.);
  const Eigen::MatrixXcd before = transfer(model, s);
  ModalModel later = model, sooner = model;
  later.join_loads(0, 2);
  sooner.join_loads(1, 0);
  EXPECT_EQ(later.load_name, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(sooner.load_name, (std::vector<std::string>{"b", "c"}));
  Eigen::MatrixXcd expected(2, 2);
  expected << before.col(0) + before.col(2), before.col(1);
  EXPECT_LT(relative(transfer(later, s), expected), 1e-14);
  expected << before.col(0) + before.col(1), before.col(2);
  EXPECT_LT(relative(transfer(sooner, s), expected), 1e-14);
}

TEST(ModalModel, FindsReadingsByName) {
  ModalModel model = random_model(3, 1, 2, 0.1);
  model.reading_label = {{"a", "", ""}, {"b", "", ""}};
  EXPECT_EQ(model.index("b"), 1);
  EXPECT_THROW(model.index("c"), std::out_of_range);
}

}  // namespace modal_model_test
