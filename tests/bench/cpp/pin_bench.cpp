// Times what a pin that is dragged costs beside the first merge of two models: the matrices are factored once, and other
// keys only ask for another solution and another seam. One line of JSON.
//
//   pin_bench [--repeat 5]

#include "options.h"

#include "lissom/merge/merge_session.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

using namespace lissom;

/// A bumpy ball with an opening of `around` vertices (the first ones) below, `rows` rows up to its pole.
WorkingMesh open_ball(int rows, int around, double radius) {
    PolygonMesh ball{Points(rows * around + 1, 3), {0}, {}};
    const auto add = [&](int a, int b, int c) {
        ball.corners.insert(ball.corners.end(), {a, b, c});
        ball.offsets.push_back(static_cast<int>(ball.corners.size()));
    };
    const int pole = rows * around;
    ball.points.row(pole) << 0, radius, 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < around; ++j) {
            const double down = 0.75 * std::numbers::pi * (rows - i) / rows, turn = 2 * std::numbers::pi * j / around;
            const double r = radius * (1 + 0.01 * std::sin(5 * turn) * std::sin(6 * down));
            ball.points.row(i * around + j) << r * std::sin(down) * std::cos(turn), r * std::cos(down), r * std::sin(down) * std::sin(turn);
            const int a = i * around + j, d = i * around + (j + 1) % around;
            if (i + 1 == rows) {
                add(a, pole, d);
                continue;
            }
            add(a, a + around, d + around);
            add(a, d + around, d);
        }
    return make_working_mesh(ball);
}

std::vector<int> opening(int around) {
    std::vector<int> loop;
    for (int j = 0; j < around; ++j) loop.push_back(j);
    return loop;
}

} // namespace

int main(int argc, char** argv) {
    const int repeat = bench::Options(argc, argv).number("--repeat", 5);
    const int source_around = 200, target_around = 300;
    const WorkingMesh source = open_ball(100, source_around, 1), target = open_ball(167, target_around, 2);
    const std::vector<MergeBoundary> boundaries{{{opening(source_around), {}}, {opening(target_around), {}}}};
    Stopwatch watch;
    MergeSession session(source, target, boundaries);
    while (session.step()) {}
    const double prepare = watch.lap();
    const auto with_key = [&](int turn) { return session.merge(std::vector<MergeKeys>{{{turn, 2 * turn}}}); };
    (void)with_key(0);
    const double first = prepare + watch.lap();
    std::vector<double> later;
    MergeResult result;
    for (int turn = 1; turn <= repeat; ++turn) {
        watch.lap();
        result = with_key(turn);
        later.push_back(watch.lap());
    }
    std::nth_element(later.begin(), later.begin() + repeat / 2, later.end());
    const double pin = later[static_cast<std::size_t>(repeat / 2)];
    std::printf("{\"source\":%d,\"target\":%d,\"prepare_s\":%.3f,\"first_merge_s\":%.3f,\"pin_s\":%.3f,\"solve_s\":%.3f,\"stitch_s\":%.3f,\"pin / first\":%.3f}\n",
                static_cast<int>(source.mesh.points.rows()), static_cast<int>(target.mesh.points.rows()), prepare, first, pin,
                result.solve_seconds, result.stitch_seconds, pin / first);
}
