#include "lissom/hair/strand_company.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_spread = 0.3;   // how far apart strands drift that still go together, per unit of length
constexpr double k_start = 1.5;    // and how far apart they may be from the start, in distances of their roots
constexpr double k_majority = 0.34; // of the neighbours that a guide with company goes together with
constexpr double k_reach = 0.3;    // of the head height
constexpr double k_closer = 0.5;   // of the distance to its guide that a follower makes up
constexpr int k_buckets = 24;      // along the longest side
constexpr int k_rings = 8;         // of buckets about a root, in which guides are looked for at most
constexpr int k_checks = 6;        // places along two strands that are compared

} // namespace

StrandCompany::StrandCompany(std::vector<Strand> guides, double head_height)
    : guides_(std::move(guides)), reach_(k_reach * head_height) {
    if (guides_.empty()) return;
    Vector3d low = Vector3d::Constant(INFINITY), high = -low;
    for (const Strand& g : guides_) {
        low = low.cwiseMin(g.root.position);
        high = high.cwiseMax(g.root.position);
    }
    buckets_.step = std::max((high - low).maxCoeff() / k_buckets, 1e-9 * head_height);
    buckets_.origin = low;
    buckets_.size = ((high - low) / buckets_.step).array().floor().cast<int>() + 1;
    bucket_.resize(static_cast<std::size_t>(buckets_.count()));
    for (std::size_t g = 0; g < guides_.size(); ++g) {
        const Eigen::Vector3i c = buckets_.local(guides_[g].root.position).cast<int>();
        bucket_[static_cast<std::size_t>(buckets_.node(c.x(), c.y(), c.z()))].push_back(static_cast<int>(g));
    }

    const int count = static_cast<int>(guides_.size());
    std::vector<std::vector<int>> neighbours(guides_.size());
    std::vector<char> accompanied(guides_.size(), 0);
    for (std::size_t g = 0; g < guides_.size(); ++g) {
        neighbours[g] = nearest(guides_[g].root, guides_[g].sides, count, nearby + 3);
        std::erase(neighbours[g], static_cast<int>(g));
        const auto with = std::count_if(neighbours[g].begin(), neighbours[g].end(), [&](int n) {
            return together(guides_[g], guides_[static_cast<std::size_t>(n)]);
        });
        accompanied[g] = static_cast<double>(with) >= k_majority * static_cast<double>(neighbours[g].size());
    }
    for (std::size_t g = 0; g < guides_.size(); ++g) {
        if (accompanied[g]) continue;
        for (const int n : neighbours[g])
            if (accompanied[static_cast<std::size_t>(n)]) { // never one that is itself being changed
                follow(guides_[g], guides_[static_cast<std::size_t>(n)]);
                break;
            }
    }
}

std::vector<int> StrandCompany::nearest(const Root& root, const PartingGuard::Sides& sides, int among, int most) const {
    if (bucket_.empty()) return {};
    const Eigen::Vector3i at = buckets_.local(root.position).cwiseMax(0.0).cast<int>().cwiseMin((buckets_.size.array() - 1).matrix());
    std::vector<std::pair<double, int>> found;
    for (int ring = 1; ring <= k_rings && static_cast<int>(found.size()) < most; ring *= 2) {
        found.clear();
        for (int z = std::max(0, at.z() - ring); z <= std::min(buckets_.size.z() - 1, at.z() + ring); ++z)
            for (int y = std::max(0, at.y() - ring); y <= std::min(buckets_.size.y() - 1, at.y() + ring); ++y)
                for (int x = std::max(0, at.x() - ring); x <= std::min(buckets_.size.x() - 1, at.x() + ring); ++x)
                    for (const int g : bucket_[static_cast<std::size_t>(buckets_.node(x, y, z))]) {
                        if (g >= among) break;
                        const Strand& guide = guides_[static_cast<std::size_t>(g)];
                        if (guide.root.normal.dot(root.normal) < 0 || PartingGuard::apart(guide.sides, sides)) continue;
                        found.emplace_back((guide.root.position - root.position).squaredNorm(), g);
                    }
    }
    const auto end = found.begin() + std::min<std::ptrdiff_t>(most, static_cast<std::ptrdiff_t>(found.size()));
    std::partial_sort(found.begin(), end, found.end());
    std::vector<int> out;
    for (auto it = found.begin(); it != end; ++it) out.push_back(it->second);
    return out;
}

bool StrandCompany::together(const Strand& a, const Strand& b) const {
    const std::size_t last = std::min(a.points.size(), b.points.size()) - 1;
    const double start = k_start * (a.points[0] - b.points[0]).norm();
    for (std::size_t i = 1; i <= k_checks; ++i) {
        const std::size_t k = last * i / k_checks;
        if ((a.points[k] - b.points[k]).norm() > start + k_spread * static_cast<double>(k) * a.segment) return false;
    }
    return true;
}

void StrandCompany::follow(Strand& strand, const Strand& guide) const {
    const Vector3d beside = strand.points[0] - guide.points[0];
    strand.points.resize(1);
    for (std::size_t k = 1; k < guide.points.size(); ++k) {
        const double along = std::min(1.0, static_cast<double>(k) * guide.segment / reach_);
        strand.points.push_back(guide.points[k] + (1 - k_closer * along) * beside);
    }
}

int StrandCompany::join(Strand& strand) const {
    const std::vector<int> near = nearest(strand.root, strand.sides, static_cast<int>(guides_.size()), nearby);
    if (near.empty()) return -1;
    for (const int g : near)
        if (together(strand, guides_[static_cast<std::size_t>(g)])) return g;
    follow(strand, guides_[static_cast<std::size_t>(near[0])]);
    return near[0];
}

} // namespace lissom
