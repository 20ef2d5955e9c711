// GEOS: the intersection of two sets of rings. geos TASK FILE
// The file: the number of edges, then for each of the two sets the number of rings, and for each ring its corners.
#include "peer.hpp"
#include <geos_c.h>
#include <memory>

static GEOSGeometry *polygons(const std::vector<double> &in, size_t &at) {
    std::vector<GEOSGeometry *> all;
    size_t rings = in[at++];
    for (size_t ring = 0; ring < rings; ++ring) {
        size_t corners = in[at++];
        GEOSCoordSequence *line = GEOSCoordSeq_create(corners + 1, 2);
        for (size_t i = 0; i <= corners; ++i) {
            size_t from = at + 2 * (i % corners);
            GEOSCoordSeq_setXY(line, i, in[from], in[from + 1]);
        }
        at += 2 * corners;
        all.push_back(GEOSGeom_createPolygon(GEOSGeom_createLinearRing(line), nullptr, 0));
    }
    return GEOSGeom_createCollection(GEOS_MULTIPOLYGON, all.data(), all.size());
}

int main(int, char **arg) {
    auto in = read_doubles(arg[2]);
    initGEOS(nullptr, nullptr);
    size_t at = 1;
    GEOSGeometry *a = polygons(in, at);
    GEOSGeometry *b = polygons(in, at);
    return timed(in[0], [&] {
        return std::unique_ptr<GEOSGeometry, void (*)(GEOSGeometry *)>(GEOSIntersection(a, b), GEOSGeom_destroy);
    });
}
