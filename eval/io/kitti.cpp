#include "eval/io/kitti.h"

#include <Eigen/SVD>
#include <string>

#include "algo/types/user_error.h"
#include "eval/io/safe_file.h"
#include "eval/io/text_table.h"

namespace honka::eval {
namespace {

constexpr Eigen::Index kRows = 3, kColumns = 4;
constexpr std::size_t kNumbers = 12;

/// Files of four decimals are within 1e-3 of orthonormal; beyond 1e-2 it is no rotation.
constexpr double kNoRotation = 1e-2;
/// What a product of rotations is off by; below it a matrix is left as it is.
constexpr double kRounding = 1e-12;

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

std::string column_name(Eigen::Index row, Eigen::Index column) {
  const std::string of_row = std::to_string(row + 1);
  return column + 1 == kColumns ? "t" + of_row : "r" + of_row + std::to_string(column + 1);
}

Pose3 pose_in(const std::filesystem::path& path, const CellRow& cells) {
  if (cells.size() != kNumbers) {
    throw_at(path, cells.front(),
             std::to_string(cells.size()) + " numbers where a KITTI row has 12: [R|t] by rows");
  }
  Eigen::Matrix<double, kRows, kColumns> values;
  for (Eigen::Index i = 0; i < kRows; ++i) {
    for (Eigen::Index j = 0; j < kColumns; ++j) {
      const Cell& cell = cells[static_cast<std::size_t>(i * kColumns + j)];
      values(i, j) = number_in(path, cell, column_name(i, j));
    }
  }
  const Eigen::Matrix3d matrix = values.leftCols<3>();
  const double deviation =
      (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  // Huge numbers overflow to a deviation that compares with nothing.
  if (!(deviation <= kNoRotation) || matrix.determinant() < 0.0) {
    throw_at(path, cells.front(),
             "the left 3 x 3 numbers are no rotation; the order is r11 r12 r13 t1 r21 …");
  }
  Pose3 pose = Pose3::Identity();
  pose.linear() = deviation <= kRounding ? matrix : nearest_rotation(matrix);
  pose.translation() = values.rightCols<1>();
  return pose;
}

}  // namespace

std::vector<Pose3> read_kitti(const std::filesystem::path& path) {
  std::vector<Pose3> poses;
  for (const CellRow& row : split_rows(read_text_file(path), Separator::kBlank)) {
    poses.push_back(pose_in(path, row));
  }
  if (poses.empty()) throw UserError(path.string() + ": no poses; give rows of 12 numbers [R|t]");
  return poses;
}

std::vector<Pose3> read_pose_rows(const std::filesystem::path& path, std::string_view text) {
  const bool commas = text.find(',') != std::string_view::npos;
  std::vector<Pose3> poses;
  for (const CellRow& row : split_rows(text, commas ? Separator::kComma : Separator::kBlank)) {
    poses.push_back(pose_in(path, row));
  }
  if (poses.empty()) throw UserError(path.string() + ": no poses; give rows of 12 numbers [R|t]");
  return poses;
}

void write_kitti(const std::filesystem::path& path, const std::vector<Pose3>& poses) {
  std::string text;
  for (const Pose3& pose : poses) {
    for (Eigen::Index i = 0; i < kRows; ++i) {
      for (Eigen::Index j = 0; j < kColumns; ++j) {
        text.append(exact_text(pose.matrix()(i, j)));
        text += i + 1 == kRows && j + 1 == kColumns ? "\n" : " ";
      }
    }
  }
  write_file_safely(path, text);
}

}  // namespace honka::eval
