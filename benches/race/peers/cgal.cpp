// CGAL: convex hulls, Delaunay triangulations, edits. cgal TASK FILE
#include "peer.hpp"
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <cstring>
#include <iterator>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

static std::vector<Kernel::Point_2> plane(const std::vector<double> &in, size_t from, size_t count) {
    std::vector<Kernel::Point_2> points;
    for (size_t i = 0; i < count; ++i) points.emplace_back(in[from + 2 * i], in[from + 2 * i + 1]);
    return points;
}

// Random splits that grow a square. A split of a face takes the next half-edge but one of the same face, one of an edge none.
static int splits(const std::vector<double> &in) {
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    using Half = Mesh::Halfedge_index;
    size_t edges = in[1], times = in[2];
    auto square = [&] {
        Mesh mesh;
        mesh.reserve(edges, edges, edges);
        std::vector<Mesh::Vertex_index> corners;
        for (int i = 0; i < 4; ++i) corners.push_back(mesh.add_vertex());
        mesh.add_face(corners);
        return mesh;
    };
    auto grow = [](Mesh &mesh, std::pair<Half, Half> edit) {
        if (edit.second == Mesh::null_halfedge()) CGAL::Euler::split_edge(edit.first, mesh);
        else CGAL::Euler::split_face(edit.first, edit.second, mesh);
    };
    std::vector<std::pair<Half, Half>> script;
    Mesh mesh = square();
    for (size_t i = 0; i < edges - 4; ++i) {
        Half h(Mesh::size_type(in[3 + 2 * i] * mesh.number_of_halfedges()));
        Half third = mesh.next(mesh.next(h));
        bool face = in[4 + 2 * i] < 0.5 && !mesh.is_border(h) && third != h && mesh.next(third) != h;
        script.emplace_back(h, face ? third : Mesh::null_halfedge());
        grow(mesh, script.back());
    }
    return timed(script.size() * times, [&] {
        std::vector<Mesh> all;
        for (size_t i = 0; i < times; ++i) {
            all.push_back(square());
            for (auto edit : script) grow(all.back(), edit);
        }
        return all;
    });
}

int main(int, char **arg) {
    if (!std::strcmp(arg[1], "version")) return std::puts(CGAL_VERSION_STR) < 0;
    auto in = read_doubles(arg[2]);
    size_t n = in[0];
    if (!std::strcmp(arg[1], "hull")) {
        auto points = plane(in, 1, n);
        return timed(n, [&] {
            std::vector<Kernel::Point_2> corners;
            CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
            return corners;
        });
    }
    if (!std::strcmp(arg[1], "delaunay")) {
        auto points = plane(in, 1, n);
        return timed(n, [&] { return CGAL::Delaunay_triangulation_2<Kernel>(points.begin(), points.end()); });
    }
    if (!std::strcmp(arg[1], "constrained")) {
        // The number of points, the points, then pairs of their numbers.
        auto points = plane(in, 1, n);
        std::vector<std::pair<size_t, size_t>> edges;
        for (size_t i = 1 + 2 * n; i + 1 < in.size(); i += 2) edges.emplace_back(in[i], in[i + 1]);
        using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
        return timed(n, [&] {
            Constrained made;
            made.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
            return made;
        });
    }
    if (!std::strcmp(arg[1], "hull in space")) {
        std::vector<Kernel::Point_3> points;
        for (size_t i = 0; i < n; ++i) points.emplace_back(in[3 * i + 1], in[3 * i + 2], in[3 * i + 3]);
        return timed(n, [&] {
            CGAL::Surface_mesh<Kernel::Point_3> made;
            CGAL::convex_hull_3(points.begin(), points.end(), made);
            return made;
        });
    }
    if (!std::strcmp(arg[1], "splits")) return splits(in);
    return 2;
}
