// GEOS: the intersection of two sets of rings, polygons of segments. geos TASK FILE
// The file: the number of edges, then for each of the two sets the number of rings, and for each ring its corners.
#include "peer.hpp"
#include <cstring>
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

using Made = std::unique_ptr<GEOSGeometry, void (*)(GEOSGeometry *)>;

int main(int, char **arg) {
    if (!std::strcmp(arg[1], "version")) return std::puts(GEOSversion()) < 0;
    auto in = read_doubles(arg[2]);
    initGEOS(nullptr, nullptr);
    if (!std::strcmp(arg[1], "polygonize")) {
        std::vector<const GEOSGeometry *> lines;
        for (size_t i = 1; i + 3 < in.size(); i += 4) {
            GEOSCoordSequence *line = GEOSCoordSeq_create(2, 2);
            GEOSCoordSeq_setXY(line, 0, in[i], in[i + 1]);
            GEOSCoordSeq_setXY(line, 1, in[i + 2], in[i + 3]);
            lines.push_back(GEOSGeom_createLineString(line));
        }
        return timed(in[0], [&] { return Made(GEOSPolygonize(lines.data(), lines.size()), GEOSGeom_destroy); });
    }
    size_t at = 1;
    GEOSGeometry *a = polygons(in, at);
    GEOSGeometry *b = polygons(in, at);
    return timed(in[0], [&] {
        return Made(GEOSIntersection(a, b), GEOSGeom_destroy);
    });
}
