// What programs do with Eigen's solvers, compiled once (eigen.cpp), with optimization.
//
// The precompiled header ends with these declarations, so that clang instantiates no body of what
// they name: that is most of the time that a program with a solver takes to compile. Each costs
// every program a little, since it makes the header larger.
//
// The list is that of Eigen 3.4, and of the course: what stands at the head of InstantiateFunction
// when `clang++ -std=c++20 -O0 -ftime-trace -c` compiles the programs that solve most
// (l3_4_riccati.cpp, l4_1_fit.cpp and l5_1_reach.cpp of examples/), and the same of the other
// solvers that programs name. What another release of Eigen has no longer is an error when the pack
// is made (node/make-pack.ts). Messages name a class as it is written here, so it is written as
// clang would name it.
#pragma once

#include <Eigen/Dense>

#ifndef MJC_EIGEN
#define MJC_EIGEN extern template
#endif

namespace Eigen {

using MjcMatrix6d = Matrix<double, 6, 6>;
using MjcVector6d = Matrix<double, 6, 1>;

MJC_EIGEN class HouseholderQR<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN void HouseholderQR<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;
MJC_EIGEN void HouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
MJC_EIGEN void HouseholderSequence<MatrixXd, VectorXd>::evalTo(MatrixXd&, VectorXd&) const;
MJC_EIGEN class ColPivHouseholderQR<Eigen::Matrix<double, -1, -1>>;

MJC_EIGEN class PartialPivLU<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN class PartialPivLU<Eigen::Matrix<std::complex<double>, -1, -1>>;
MJC_EIGEN class FullPivLU<Eigen::Matrix<double, -1, -1>>;

MJC_EIGEN class LLT<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
MJC_EIGEN class LDLT<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
MJC_EIGEN void LDLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;
MJC_EIGEN void LDLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;
MJC_EIGEN void LDLT<MatrixXd>::_solve_impl_transposed<true>(const MatrixXd&, MatrixXd&) const;
MJC_EIGEN void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&, VectorXd&) const;
MJC_EIGEN class LDLT<Eigen::Matrix<double, 6, 6>>;
MJC_EIGEN LDLT<MjcMatrix6d>& LDLT<MjcMatrix6d>::compute(const EigenBase<MjcMatrix6d>&);
MJC_EIGEN void LDLT<MjcMatrix6d>::_solve_impl(const MjcVector6d&, MjcVector6d&) const;
MJC_EIGEN void LDLT<MjcMatrix6d>::_solve_impl_transposed<true>(const MjcVector6d&,
                                                               MjcVector6d&) const;

MJC_EIGEN class HessenbergDecomposition<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN class RealSchur<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
MJC_EIGEN class EigenSolver<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
MJC_EIGEN class SelfAdjointEigenSolver<Eigen::Matrix<double, -1, -1>>;
MJC_EIGEN SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(
    const EigenBase<MatrixXd>&, int);

namespace internal {

using MjcPart = Block<MatrixXd, Dynamic, Dynamic, false>;

MJC_EIGEN void apply_block_householder_on_the_left(MjcPart&, const MjcPart&,
                                                   const VectorBlock<const VectorXd>&, bool);
MJC_EIGEN struct householder_qr_inplace_blocked<MatrixXd, VectorXd>;
MJC_EIGEN struct compute_inverse<MatrixXd, MatrixXd, Dynamic>;
MJC_EIGEN struct compute_inverse<MatrixXcd, MatrixXcd, Dynamic>;

// Both factors by columns or by rows.
MJC_EIGEN struct general_matrix_matrix_product<Index, double, ColMajor, false, double, ColMajor,
                                               false, ColMajor, 1>;
MJC_EIGEN struct general_matrix_matrix_product<Index, double, RowMajor, false, double, ColMajor,
                                               false, ColMajor, 1>;
MJC_EIGEN struct general_matrix_matrix_product<Index, double, ColMajor, false, double, RowMajor,
                                               false, ColMajor, 1>;
MJC_EIGEN struct general_matrix_matrix_product<Index, double, RowMajor, false, double, RowMajor,
                                               false, ColMajor, 1>;

MJC_EIGEN struct triangular_solve_matrix<double, Index, OnTheLeft, Lower, false, ColMajor, ColMajor,
                                         1>;
MJC_EIGEN struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, ColMajor,
                                         1>;
MJC_EIGEN struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor,
                                         ColMajor, 1>;
MJC_EIGEN struct triangular_solve_matrix<double, Index, OnTheLeft, UnitUpper, false, ColMajor,
                                         ColMajor, 1>;

}  // namespace internal
}  // namespace Eigen
