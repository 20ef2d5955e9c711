// OpenSubdiv: one step of subdivision. opensubdiv TASK FILE
// The file: new faces, vertices, faces, corners of a face, places, corners.
#include "peer.hpp"
#include <cstring>
#include <memory>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/version.h>

using namespace OpenSubdiv;

struct Place {
    double x[3];
    void Clear(void * = nullptr) { x[0] = x[1] = x[2] = 0; }
    void AddWithWeight(const Place &from, double weight) {
        for (int i = 0; i < 3; ++i) x[i] += weight * from.x[i];
    }
};

int main(int, char **arg) {
    if (!std::strcmp(arg[1], "version"))
        return std::printf("%d.%d\n", OPENSUBDIV_VERSION_NUMBER / 10000, OPENSUBDIV_VERSION_NUMBER / 100 % 100) < 0;
    auto in = read_doubles(arg[2]);
    int vertices = in[1], faces = in[2], corners = in[3];
    const double *numbers = in.data() + 4;
    std::vector<Place> places(vertices);
    for (auto &place : places)
        for (double &x : place.x) x = *numbers++;
    std::vector<int> counts(faces, corners), list(numbers, numbers + size_t(faces) * corners);
    Far::TopologyDescriptor lists;
    lists.numVertices = vertices;
    lists.numFaces = faces;
    lists.numVertsPerFace = counts.data();
    lists.vertIndicesPerFace = list.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    auto scheme = std::strcmp(arg[1], "loop") ? Sdc::SCHEME_CATMARK : Sdc::SCHEME_LOOP;
    // A base is refined once; making it is not measured.
    std::vector<std::unique_ptr<Far::TopologyRefiner>> ready;
    for (int i = 0; i < 4; ++i) ready.emplace_back(Factory::Create(lists, Factory::Options(scheme, Sdc::Options())));
    return timed(in[0], [&] {
        auto base = std::move(ready.back());
        ready.pop_back();
        Far::TopologyRefiner::UniformOptions once(1);
        once.fullTopologyInLastLevel = true;
        base->RefineUniform(once);
        std::vector<Place> finer(base->GetLevel(1).GetNumVertices());
        Far::PrimvarRefiner(*base).Interpolate(1, places, finer);
        return std::make_pair(std::move(base), std::move(finer));
    });
}
