#include "algo/delaunay/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "algo/types/user_error.h"

namespace honka {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<std::int32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

/// The distinct places in lexicographic order, and where each input point went.
struct Places {
  std::vector<std::int32_t> input;  ///< per place: lowest input index
  std::vector<std::int32_t> place;  ///< per input point
};

void check_finite(const std::vector<Eigen::Vector2d>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw UserError(fmt::format(
          "point {} of {} is ({}, {}): a stem needs two finite coordinates; remove or mend it",
          i + 1, points.size(), points[i].x(), points[i].y()));
    }
  }
}

Places sort_places(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](std::int32_t i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    return std::pair(p.x(), p.y());
  };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(at(a), a) < std::pair(at(b), b);
  });
  Places places;
  places.place.resize(points.size());
  for (const std::int32_t i : order) {
    if (places.input.empty() || at(places.input.back()) != at(i)) places.input.push_back(i);
    places.place[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(places.input.size()) - 1;
  }
  return places;
}

Triangulation triangulate(const std::vector<Eigen::Vector2d>& points, const Places& places) {
  std::vector<std::pair<Kernel::Point_2, std::int32_t>> input;
  input.reserve(places.input.size());
  for (const std::int32_t i : places.input) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    input.emplace_back(Kernel::Point_2(p.x(), p.y()), static_cast<std::int32_t>(input.size()));
  }
  Triangulation triangulation;
  triangulation.insert(input.begin(), input.end());
  return triangulation;
}

/// Position (0, 1, 2) of the face's vertex with the lowest place.
int first_corner(Triangulation::Face_handle face) {
  int first = 0;
  for (int k = 1; k < 3; ++k) {
    if (face->vertex(k)->info() < face->vertex(first)->info()) first = k;
  }
  return first;
}

std::array<std::int32_t, 3> corners(Triangulation::Face_handle face) {
  const int first = first_corner(face);
  return {face->vertex(first)->info(), face->vertex((first + 1) % 3)->info(),
          face->vertex((first + 2) % 3)->info()};
}

std::vector<Triangulation::Face_handle> sort_faces(const Triangulation& triangulation) {
  std::vector<Triangulation::Face_handle> faces;
  for (const auto face : triangulation.finite_face_handles()) faces.push_back(face);
  std::sort(faces.begin(), faces.end(),
            [](const auto& a, const auto& b) { return corners(a) < corners(b); });
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i]->info() = static_cast<std::int32_t>(i);
  return faces;
}

/// Area and squared perimeter, from differences of the corners: exact enough at UTM coordinates.
void measure(const std::vector<Eigen::Vector2d>& points, DelaunayTriangle& triangle) {
  const auto corner = [&](std::size_t k) -> const Eigen::Vector2d& {
    return points[static_cast<std::size_t>(triangle.vertices[k])];
  };
  const Eigen::Vector2d ab = corner(1) - corner(0);
  const Eigen::Vector2d ac = corner(2) - corner(0);
  const double perimeter = ab.norm() + ac.norm() + (ac - ab).norm();
  triangle.area_m2 = 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  triangle.perimeter_squared_m2 = perimeter * perimeter;
}

}  // namespace

DelaunayGraph build_delaunay(const std::vector<Eigen::Vector2d>& points_m) {
  check_finite(points_m);
  const Places places = sort_places(points_m);
  const Triangulation triangulation = triangulate(points_m, places);

  DelaunayGraph graph{points_m, {}, std::vector<std::uint8_t>(points_m.size(), 0)};
  for (const auto face : sort_faces(triangulation)) {
    DelaunayTriangle triangle;
    const int first = first_corner(face);
    for (int k = 0; k < 3; ++k) {
      const int corner = (first + k) % 3;
      const auto slot = static_cast<std::size_t>(k);
      const auto place = static_cast<std::size_t>(face->vertex(corner)->info());
      triangle.vertices[slot] = places.input[place];
      const auto neighbour = face->neighbor(corner);
      if (!triangulation.is_infinite(neighbour)) triangle.neighbours[slot] = neighbour->info();
    }
    measure(points_m, triangle);
    graph.triangles.push_back(triangle);
  }

  std::vector<std::uint8_t> place_on_hull(places.input.size(), triangulation.dimension() < 2);
  if (triangulation.dimension() == 2) {
    auto vertex = triangulation.incident_vertices(triangulation.infinite_vertex());
    const auto done = vertex;
    do {
      place_on_hull[static_cast<std::size_t>(vertex->info())] = 1;
    } while (++vertex != done);
  }
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    graph.on_hull[i] = place_on_hull[static_cast<std::size_t>(places.place[i])];
  }
  return graph;
}

}  // namespace honka
