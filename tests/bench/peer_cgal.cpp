// CGAL on one case: peer_cgal CASE NODES.txt OUT.msh [LLOYD ROUNDS], CASE: graded-MINIMUM or disc. Prints
// mesh_cpu=SECONDS of the calls that make and optimise the mesh. Built by peers.sh only.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_conformer_2.h>
#include <CGAL/lloyd_optimize_mesh_2.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <unordered_map>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Point = Cdt::Point;

namespace {

bool graded = false;
double minimum = 0.0; ///< node spacing, everywhere if not graded

/// The node spacing of peer_cases.py.
double rho(const Point &p) {
    return graded ? std::max(minimum, 0.232 * std::abs(std::hypot(p.x() - 30.0, p.y() - 20.0) - 12.0)) : minimum;
}

/// Longest edge at most kBound·ρ; CGAL bounds edges from above, so that they are shorter on average. Chosen so that the
/// numbers of elements are about those of the others.
constexpr double kBound = 1.45;

class SizedCriteria {
  public:
    struct Quality {
        double size = 0.0;                           ///< longest edge / bound; above 1 it is too long
        double shape = 0.0;                          ///< squared sine of the minimum angle
        bool operator<(const Quality &other) const { // worse first
            const double a = std::max(size, 1.0), b = std::max(other.size, 1.0);
            return a != b ? a > b : shape < other.shape;
        }
    };
    class Is_bad {
      public:
        CGAL::Mesh_2::Face_badness operator()(const Quality q) const {
            constexpr double kShape = 0.125; // sin² of 20.7 degrees, the bound that CGAL guarantees
            return q.size > 1.0       ? CGAL::Mesh_2::IMPERATIVELY_BAD
                   : q.shape < kShape ? CGAL::Mesh_2::BAD
                                      : CGAL::Mesh_2::NOT_BAD;
        }
        CGAL::Mesh_2::Face_badness operator()(const Cdt::Face_handle &face, Quality &q) const {
            const Point a = face->vertex(0)->point(), b = face->vertex(1)->point(), c = face->vertex(2)->point();
            double l[] = {CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)};
            std::sort(l, l + 3);
            const double twiceArea = 2.0 * std::abs(CGAL::area(a, b, c));
            q.shape = twiceArea * twiceArea / (l[1] * l[2]);
            q.size = std::sqrt(l[2]) / (kBound * rho(CGAL::centroid(a, b, c)));
            return (*this)(q);
        }
    };
    Is_bad is_bad_object() const { return {}; }
};

void write(const Cdt &cdt, const char *path) {
    std::ofstream out(path);
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << cdt.number_of_vertices() << '\n';
    std::unordered_map<const void *, std::size_t> number;
    for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v) {
        const std::size_t n = number.size() + 1;
        number[&*v] = n;
        out << n << ' ' << v->point().x() << ' ' << v->point().y() << " 0\n";
    }
    std::vector<Cdt::Face_handle> inside;
    for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
        if (f->is_in_domain()) {
            inside.push_back(f);
        }
    }
    out << "$EndNodes\n$Elements\n" << inside.size() << '\n';
    std::size_t e = 0;
    for (const Cdt::Face_handle f : inside) {
        out << ++e << " 2 2 1 1 " << number[&*f->vertex(0)] << ' ' << number[&*f->vertex(1)] << ' '
            << number[&*f->vertex(2)] << '\n';
    }
    out << "$EndElements\n";
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 4) {
        return 2;
    }
    const std::string name = argv[1];
    graded = name.starts_with("graded-");
    const int rounds = argc > 4 ? std::atoi(argv[4]) : 0;
    std::ifstream in(argv[2]);
    std::vector<Point> points;
    for (double x, y; in >> x >> y;) {
        points.emplace_back(x, y);
    }
    minimum = graded ? std::stod(name.substr(7)) : std::sqrt(CGAL::squared_distance(points[0], points[1]));
    Cdt cdt;
    for (std::size_t i = 0; i < points.size(); ++i) {
        cdt.insert_constraint(points[i], points[(i + 1) % points.size()]);
    }
    const std::clock_t start = std::clock();
    CGAL::Delaunay_mesher_2<Cdt, SizedCriteria> mesher(cdt, SizedCriteria());
    mesher.refine_mesh();
    if (rounds > 0) {
        CGAL::lloyd_optimize_mesh_2(cdt, CGAL::parameters::max_iteration_number = rounds);
    }
    std::printf("mesh_cpu=%.6f\n", static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    write(cdt, argv[3]);
    return 0;
}
