// qhull: the convex hull of points in space. qhull TASK FILE
#include "peer.hpp"
extern "C" {
#include <libqhull_r/qhull_ra.h>
}
#include <cstring>
#include <memory>

struct Made {
    qhT state;
    ~Made() {
        int current, all;
        qh_freeqhull(&state, !qh_ALL);
        qh_memfreeshort(&state, &current, &all);
    }
};

int main(int, char **arg) {
    if (!std::strcmp(arg[1], "version")) return std::puts(qh_version) < 0;
    auto in = read_doubles(arg[2]);
    int n = in[0];
    return timed(n, [&] {
        auto made = std::make_unique<Made>();
        qh_zero(&made->state, stderr);
        char flags[] = "qhull";
        if (qh_new_qhull(&made->state, 3, n, in.data() + 1, False, flags, nullptr, stderr)) std::exit(3);
        return made;
    });
}
