// CGAL: arrangements of segments. arrangement TASK FILE
// The file: the number of segments and their ends; or that of edges, and two sets of rings as for geos.cpp.
#include "peer.hpp"
#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_non_caching_segment_traits_2.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <cstring>

using Plain = CGAL::Arrangement_2<CGAL::Arr_non_caching_segment_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>>;
using Exact = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>>;

static Exact rings(const std::vector<double> &in, size_t &at) {
    std::vector<Exact::X_monotone_curve_2> all;
    size_t count = in[at++];
    for (size_t ring = 0; ring < count; ++ring) {
        size_t corners = in[at++];
        auto corner = [&](size_t i) { return Exact::Point_2(in[at + 2 * (i % corners)], in[at + 2 * (i % corners) + 1]); };
        for (size_t i = 0; i < corners; ++i) all.emplace_back(corner(i), corner(i + 1));
        at += 2 * corners;
    }
    Exact made;
    CGAL::insert_non_intersecting_curves(made, all.begin(), all.end());
    return made;
}

int main(int, char **arg) {
    if (!std::strcmp(arg[1], "version")) return std::puts(CGAL_VERSION_STR) < 0;
    auto in = read_doubles(arg[2]);
    if (!std::strcmp(arg[1], "segments")) {
        std::vector<Plain::X_monotone_curve_2> all;
        for (size_t i = 1; i + 3 < in.size(); i += 4)
            all.emplace_back(Plain::Point_2(in[i], in[i + 1]), Plain::Point_2(in[i + 2], in[i + 3]));
        return timed(in[0], [&] {
            Plain made;
            CGAL::insert_non_intersecting_curves(made, all.begin(), all.end());
            return made;
        });
    }
    if (!std::strcmp(arg[1], "overlay")) {
        size_t at = 1;
        Exact a = rings(in, at), b = rings(in, at);
        return timed(in[0], [&] {
            Exact made;
            CGAL::Arr_default_overlay_traits<Exact> traits;
            CGAL::overlay(a, b, made, traits);
            return made;
        });
    }
    return 2;
}
