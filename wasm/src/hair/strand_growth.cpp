#include "lissom/hair/strand_growth.h"

#include "demand.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/smooth.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

enum Purpose : std::uint64_t { in_layer = 10, in_length = 11, in_root = 12, in_lock = 13 };

constexpr double k_least = 0.05;       // magnitude at which a strand ends (Fu 4.6)
constexpr double k_sure = 0.12;        // of the head height: up to here a strand grows through a faint field
constexpr double k_rise = 0.18;        // of the head height: over which hair lifts to its height
constexpr double k_clearance = 0.003;  // of the head height: nearest to the skin beyond the root
constexpr double k_lift = 0.35;        // steepest rise off the skin, per unit of length

constexpr double k_turn = 12;          // points for one turn of a wave
constexpr double k_enough = 0.25;      // of a piece that may be lacking, rather than twice the points
constexpr double k_ahead = 2.5, k_over = 0.7; // how many segments ahead a strand looks, and its steepest rise then

constexpr double k_lock = 0.05;        // of the head height: hair that ends together
constexpr double k_fray = 0.6;         // how much of what is left of the variation is each strand's own
constexpr std::uint64_t k_roots = 16; // places tried for a root that is not on a parting's line

/// In [0, 1): the same for all roots of a lock, easing over to the next one's.
double of_lock(const Vector3d& root, double size, std::uint64_t seed) {
    const Vector3d q = root / size, low = q.array().floor();
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::uint64_t number = 0;
        for (int d = 0; d < 3; ++d) {
            const int far = corner >> d & 1;
            const double t = smooth(q[d] - low[d]);
            weight *= far ? t : 1 - t;
            number = number << 20 ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(low[d]) + far);
        }
        sum += weight * chance(seed, number, in_lock);
    }
    return sum;
}

} // namespace

StrandGrowth::StrandGrowth(const HairVolume& volume, const HeadDistance& head, const VectorField& field,
                           const ScalpRoots& roots, const PartingGuard& partings, GrowthOptions options)
    : volume_(volume), head_(head), field_(field), roots_(roots), partings_(partings), options_(std::move(options)) {
    length_ = options_.length.value_or(volume.head_height);
    height_ = options_.volume.value_or(0.03 * volume.head_height);
    demand(options_.step >= 0.1 && options_.step <= 2, "The step of a strand is 0.1 to 2 grid steps.");
    demand(length_ > 0 && std::isfinite(length_), "The length of hair is a number above 0.");
    demand(height_ >= 0 && std::isfinite(height_), "The volume of hair is a number from 0 on.");
    demand(options_.length_variation >= 0 && options_.length_variation <= 1, "The variation of length is 0 to 1.");
    demand(options_.length_map.empty() || options_.length_map.size() == static_cast<std::size_t>(volume.head.vertex_count()),
           "The painted length needs one number for each vertex of the head.");
    demand(!options_.wave || *options_.wave > 0, "The length of a wave is a number above 0.");
    segment_ = std::max(options_.step * volume.field.step, length_ / (max_points - 1));
    if (!options_.wave) return;
    double longest = length_;
    for (const float factor : options_.length_map) longest = std::max(longest, length_ * static_cast<double>(factor));
    const double most = (max_points - 1) / std::min<double>(max_points - 1, std::ceil(longest / segment_));
    pieces_ = static_cast<int>(std::clamp(std::ceil(k_turn * segment_ / *options_.wave - k_enough), 1.0, std::floor(most)));
}

Root StrandGrowth::root_of(std::uint64_t index) const {
    Root root = roots_.root(index, options_.seed);
    for (std::uint64_t other = 0; other < k_roots && partings_.on_line(root.position); ++other)
        root = roots_.root(index, hash_bits(options_.seed, other, in_root));
    return root;
}

double StrandGrowth::length_of(const Root& root, std::uint64_t index) const {
    double painted = 1;
    if (!options_.length_map.empty()) {
        const auto corner = [&](int k) -> double {
            return options_.length_map[static_cast<std::size_t>(volume_.head.triangles(root.triangle, k))];
        };
        painted = (1 - root.b - root.c) * corner(0) + root.b * corner(1) + root.c * corner(2);
    }
    // Locks end together, a little frayed; strands that each ended anywhere would look like a broom.
    const double lock = of_lock(root.position, k_lock * volume_.head_height, options_.seed);
    const double u = lock + (1 - lock) * k_fray * chance(options_.seed, index, in_length);
    return length_ * std::max(0.0, painted) * (1 - options_.length_variation * u * u);
}

double StrandGrowth::clearance_at(double along, double head_height) { return std::min(k_clearance * head_height, 0.5 * along); }

Vector3d StrandGrowth::lifted(const HeadDistance& head, const Vector3d& p, double clearance) {
    Vector3d q = p;
    for (int round = 0; round < 12; ++round) {
        const HeadDistance::Sample s = head.sample(q);
        if (s.distance >= clearance) break;
        const double slope = s.gradient.norm();
        if (slope < 1e-6) break;
        q += (clearance - s.distance + 1e-4 * clearance) / std::max(slope, 0.3) * s.gradient / slope;
    }
    return q;
}

Strand StrandGrowth::grow(std::uint64_t index) const {
    const double h = volume_.head_height;
    Strand strand{root_of(index), {}, segment_, {}};
    strand.sides = partings_.sides(strand.root.position);
    const bool beside_parting = std::any_of(strand.sides.begin(), strand.sides.end(), [](std::int8_t side) { return side != 0; });
    const double length = std::min(length_of(strand.root, index), segment_ * (max_points - 1));
    const double height = height_ * (0.2 + 0.8 * chance(options_.seed, index, in_layer));

    Vector3d p = strand.root.position, before = strand.root.normal;
    strand.points.push_back(p);
    // Zero: the strand ends.
    const auto direction = [&](const Vector3d& at, bool sure) -> Vector3d {
        const Vector3d v = field_.at(at);
        const double magnitude = v.norm();
        if (magnitude >= k_least) return v / magnitude;
        return sure ? before : Vector3d::Zero();
    };
    for (double walked = 0; walked < length - 1e-9 * length;) {
        const double l = std::min(segment_, length - walked);
        const bool sure = walked < k_sure * h;
        const Vector3d first = direction(p, sure);
        if (first.isZero()) break;
        Vector3d v = direction(p + 0.5 * l * first, sure);
        if (v.isZero()) break;

        const bool near_root = walked < StrandGrowth::parting_reach * h;
        const HeadDistance::Sample skin = head_.sample(p);
        const double share = height * smooth((walked + l) / (k_rise * h));
        if (skin.distance < share + l) {
            const Vector3d n = skin.gradient.normalized();
            const double inward = std::min(0.0, v.dot(n) + std::max(0.0, skin.distance - share) / l);
            v -= inward * n;
            if (skin.distance < share) v += std::min(k_lift, (share - skin.distance) / l) * n;
            v.normalize();
            // What stands out ahead (an ear) is passed over, not round: hair would part there.
            const double ahead = head_.at(p + k_ahead * l * v);
            if (ahead < 0.5 * share) v = (v + std::min(k_over, (0.5 * share - ahead) / (k_ahead * l)) * n).normalized();
        }
        if (near_root) {
            // Over a parting's line both sides' vectors cancel but for their rise: hair there would stand up.
            if (beside_parting) {
                const Vector3d n = skin.gradient.normalized();
                v -= std::max(0.0, v.dot(n) - std::max(0.0, share - skin.distance) / l) * n;
            }
            v = partings_.outward(p, v, strand.sides).normalized();
        }

        Vector3d next = p + l * v;
        next = lifted(head_, next, clearance_at(walked + l, h));
        if (near_root) next = partings_.kept(next, strand.sides);
        if (!volume_.field.contains(next) || !next.allFinite()) break;
        before = v;
        p = next;
        walked += l;
        strand.points.push_back(p);
        if (static_cast<int>(strand.points.size()) == max_points) break;
    }
    return refined(std::move(strand), pieces_);
}

Strand refined(Strand strand, int pieces) {
    if (pieces <= 1 || strand.points.size() < 2) return strand;
    const std::vector<Vector3d> coarse = std::move(strand.points);
    const std::size_t last = coarse.size() - 1;
    strand.points.clear();
    strand.points.reserve(last * static_cast<std::size_t>(pieces) + 1);
    for (std::size_t k = 0; k < last; ++k) {
        const Vector3d from = 0.5 * (coarse[k + 1] - coarse[k == 0 ? 0 : k - 1]) * (k == 0 ? 2 : 1);
        const Vector3d to = 0.5 * (coarse[std::min(k + 2, last)] - coarse[k]) * (k + 1 == last ? 2 : 1);
        for (int i = 0; i < pieces; ++i) {
            const double t = static_cast<double>(i) / pieces, u = t * t, w = u * t;
            strand.points.push_back((2 * w - 3 * u + 1) * coarse[k] + (w - 2 * u + t) * from +
                                    (3 * u - 2 * w) * coarse[k + 1] + (w - u) * to);
        }
    }
    strand.points.push_back(coarse.back());
    strand.segment /= pieces;
    return strand;
}

} // namespace lissom
