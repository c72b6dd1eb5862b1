#include "lissom/hair/strand_detail.h"

#include "demand.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/smooth.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {

using Eigen::Vector3d;

namespace {

enum Purpose : std::uint64_t { in_clump = 20, in_phase, in_turn, in_radius, in_frizz, in_flyaway, in_shape };

// Sizes in head heights.
constexpr double k_curl_radius = 0.04, k_curl_length = 0.16, k_curl_rise = 0.25;
constexpr double k_turn_least = 0.8, k_turn_spread = 0.4; // turns of a clump, as shares of their length
constexpr double k_radius_least = 0.7, k_radius_of_clump = 0.4, k_radius_own = 0.3; // and their radii
constexpr double k_radius_most = k_radius_least + k_radius_of_clump + k_radius_own;
constexpr double k_frizz_size = 0.014, k_frizz_length = 0.05, k_frizz_rise = 0.12;
constexpr double k_flyaway_size = 0.045, k_flyaway_length = 0.3;
constexpr double k_apart = 0.12;
constexpr double k_large_share = 0.45; // of the clumping that the large clumps do

/// Smooth noise of one variable in [-1, 1]³: random vectors at whole numbers, eased between.
Vector3d noise(double t, std::uint64_t seed, std::uint64_t strand, std::uint64_t purpose) {
    const double low = std::floor(t);
    const auto at = [&](double knot) -> Vector3d {
        const std::uint64_t bits = hash_bits(hash_bits(seed, strand, purpose) + static_cast<std::uint64_t>(knot));
        return {unit(bits) * 2 - 1, unit(hash_bits(bits)) * 2 - 1, unit(hash_bits(bits ^ 0x5bf03635u)) * 2 - 1};
    };
    const double w = smooth(t - low);
    return (1 - w) * at(low) + w * at(low + 1);
}

} // namespace

std::optional<double> shortest_turn(const DetailOptions& options, double head_height) {
    if (!(options.curl > 0) || (options.curl_length && !(*options.curl_length > 0))) return {};
    const double turn = k_turn_least * options.curl_length.value_or(k_curl_length * head_height);
    const double slope = 2 * std::numbers::pi * k_radius_most * options.curl * k_curl_radius * head_height / turn;
    return turn * std::min(2.0, std::sqrt(1 + slope * slope) / slope);
}

StrandDetail::StrandDetail(const HairVolume& volume, const HeadDistance& head, const PartingGuard& partings,
                           const TailTie& ties, const DetailOptions& options, std::uint64_t seed,
                           std::vector<Strand> guide_strands)
    : volume_(volume), head_(head), partings_(partings), ties_(ties), options_(options), seed_(seed),
      company_(std::move(guide_strands), volume.head_height) {
    for (const double share : {options.clump, options.curl, options.frizz, options.flyaways})
        demand(share >= 0 && share <= 1, "Clump, curl, frizz and flyaways go from 0 to 1.");
    demand(!options.curl_length || *options.curl_length > 0, "The length of a curl is a number above 0.");

    const std::vector<Strand>& guides = company_.guides();
    large_.assign(guides.size(), -1);
    for (int g = 0; g < static_cast<int>(guides.size()); ++g) { // small clumps lean together into large ones
        Strand& guide = company_.guide(g);
        const std::vector<int> large = company_.nearest(guide.root, guide.sides, large_guides, 1);
        if (large.empty()) continue;
        large_[static_cast<std::size_t>(g)] = large[0];
        if (g >= large_guides) gather(guide, company_.guide(large[0]), k_large_share * options_.clump, 0.1);
    }
}

void StrandDetail::gather(Strand& strand, const Strand& guide, double strength, double root_share) const {
    const std::size_t count = strand.points.size(), last = guide.points.size() - 1;
    const double apart = k_apart * volume_.head_height;
    Vector3d offset = Vector3d::Zero();
    for (std::size_t k = 1; k < count; ++k) {
        const double along = static_cast<double>(k) / static_cast<double>(count - 1);
        // Beyond the guide's end the offset stays what it was there. What has parted company is left alone.
        if (k <= last) offset = guide.points[k] - strand.points[k];
        const double company = 1 / (1 + offset.squaredNorm() / (apart * apart));
        strand.points[k] += strength * smooth((along - root_share) / (1 - root_share)) * company * offset;
    }
}

void StrandDetail::curl(Strand& strand, std::uint64_t index, std::uint64_t clump,
                        const std::vector<double>& looseness) const {
    const double h = volume_.head_height;
    const double turn = options_.curl_length.value_or(k_curl_length * h) * (k_turn_least + k_turn_spread * chance(seed_, clump, in_turn));
    const double phase = chance(seed_, clump, in_phase) + 0.15 * chance(seed_, index, in_phase);
    const double radius = options_.curl * k_curl_radius * h *
                          (k_radius_least + k_radius_of_clump * chance(seed_, clump, in_radius) + k_radius_own * chance(seed_, index, in_radius));
    const double hand = hash_bits(seed_, clump, in_shape) & 1 ? 1 : -1;
    const std::vector<Vector3d> line = strand.points;
    Vector3d across = strand.root.normal;
    for (std::size_t k = 1; k < line.size(); ++k) {
        const Vector3d tangent = (line[std::min(k + 1, line.size() - 1)] - line[k - 1]).normalized();
        across -= across.dot(tangent) * tangent; // carried along without twist
        if (across.norm() < 1e-6) across = tangent.unitOrthogonal();
        across.normalize();
        const double along = static_cast<double>(k) * strand.segment;
        const double angle = 2 * std::numbers::pi * (hand * along / turn + phase);
        const double r = looseness[k] * radius * smooth(along / (k_curl_rise * h));
        strand.points[k] += r * (std::cos(angle) * across + std::sin(angle) * tangent.cross(across));
    }
}

void StrandDetail::roughen(Strand& strand, std::uint64_t index, const std::vector<double>& looseness) const {
    const double h = volume_.head_height;
    const bool stray = chance(seed_, index, in_flyaway) < options_.flyaways;
    const double frizz = options_.frizz * (stray ? 1.6 : 1) * k_frizz_size * h * (0.4 + 1.2 * chance(seed_, index, in_radius));
    const double far = chance(seed_, index, in_shape);
    const double stand = stray ? k_flyaway_size * h * (0.15 + far * far) : 0; // most of them a little, a few clearly
    const double start = 16 * chance(seed_, index, in_turn);
    if (frizz == 0 && stand == 0) return;
    for (std::size_t k = 1; k < strand.points.size(); ++k) {
        const double along = static_cast<double>(k) * strand.segment;
        Vector3d& p = strand.points[k];
        const double t = start + along / (k_frizz_length * h);
        p += looseness[k] * frizz * smooth(along / (k_frizz_rise * h)) *
             (0.65 * noise(t / 2.7, seed_, index, in_frizz) + 0.35 * noise(t, seed_, index + 1, in_frizz));
        if (stand > 0) {
            Vector3d way = noise(along / (k_flyaway_length * h), seed_, index, in_flyaway);
            const Vector3d out = head_.gradient(p);
            way += 0.3 * out;
            p += looseness[k] * stand * smooth(along / (0.6 * h)) * way;
        }
    }
}

int StrandDetail::apply(Strand& strand, std::uint64_t index) const {
    const double h = volume_.head_height;
    const bool stray = chance(seed_, index, in_flyaway) < options_.flyaways;
    const int guide = company_.join(strand);
    const std::vector<double> looseness = ties_.looseness(strand.points, strand.segment);
    if (guide >= 0 && options_.clump > 0 && !stray) {
        const double own = 0.6 + 0.4 * chance(seed_, index, in_clump);
        gather(strand, company_.guides()[static_cast<std::size_t>(guide)], options_.clump * own, 0.05);
    }
    if (options_.curl > 0) curl(strand, index, guide >= 0 ? static_cast<std::uint64_t>(guide) : index, looseness);
    roughen(strand, index, looseness);
    ties_.draw(strand.points);
    double walked = 0; // along the strand as it now is: that is what a centimetre is promised of
    for (std::size_t k = 1; k < strand.points.size(); ++k) {
        const double along = static_cast<double>(k) * strand.segment;
        Vector3d& p = strand.points[k];
        const bool guarded = walked < StrandGrowth::parting_reach * h;
        if (guarded) p = partings_.kept(p, strand.sides);
        p = StrandGrowth::lifted(head_, p, StrandGrowth::clearance_at(along, h));
        if (guarded) p = partings_.kept(p, strand.sides);
        walked += (p - strand.points[k - 1]).norm();
    }
    const int large = guide >= 0 ? large_[static_cast<std::size_t>(guide)] : -1;
    return large >= 0 ? large : large_guides;
}

} // namespace lissom
