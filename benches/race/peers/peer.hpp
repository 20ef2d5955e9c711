// What every program of this folder does: it reads doubles from a file, works once, and prints nanoseconds an element,
// the median of three more times. The file: the number of elements, then what the task needs.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

inline std::vector<double> read_doubles(const char *path) {
    std::FILE *file = std::fopen(path, "rb");
    if (!file) std::exit(2);
    std::fseek(file, 0, SEEK_END);
    std::vector<double> all(std::ftell(file) / sizeof(double));
    std::rewind(file);
    if (std::fread(all.data(), sizeof(double), all.size(), file) != all.size()) std::exit(2);
    std::fclose(file);
    return all;
}

// Processor time in nanoseconds.
inline double now() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * t.tv_sec + t.tv_nsec;
}

// `work` hands back what it made, so that dropping it is not measured.
template <typename Work> int timed(double elements, Work work) {
    { auto made = work(); (void)made; }
    std::vector<double> times;
    for (int i = 0; i < 3; ++i) {
        double start = now();
        auto made = work();
        times.push_back((now() - start) / elements);
        (void)made;
    }
    std::sort(times.begin(), times.end());
    std::printf("%.17g\n", times[1]);
    return 0;
}
