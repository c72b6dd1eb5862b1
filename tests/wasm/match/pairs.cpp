#include "pairs.h"

#include "shapes.h"

#include "lissom/match/pairwise_match.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/triangle_tree.h"

#include <doctest/doctest.h>

#include <Eigen/QR>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

namespace pairs {

using namespace lissom;
using Eigen::RowVector3d;

std::map<std::string, int> landmarks(const std::string& name) {
    std::map<std::string, int> found;
    const char* given = std::getenv("LISSOM_SHARED");
    for (const std::string& root : {std::string(given ? given : "../shared"), std::string("../../../shared"), std::string("../../shared")}) {
        std::ifstream file(root + "/data/" + name + ".json");
        std::stringstream text;
        text << file.rdbuf();
        const std::string all = text.str();
        const std::size_t first = all.find("\"landmarks\"");
        if (first == std::string::npos) continue;
        const std::string list = all.substr(first + 12, all.find('}', first) - first - 12);
        const std::regex form(R"re("(\w+)":\s*(\d+))re");
        for (std::sregex_iterator m(list.begin(), list.end(), form), end; m != end; ++m) found[(*m)[1]] = std::stoi((*m)[2]);
        break;
    }
    return found;
}

Points places(const TriangleMesh& mesh, const std::vector<int>& vertices) {
    Points rows(std::ssize(vertices), 3);
    for (std::size_t k = 0; k < vertices.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = mesh.points.row(vertices[k]);
    return rows;
}

Matched run(const TriangleMesh& source, const TriangleMesh& target, const Points& from, const Points& to, const MatchOptions& options) {
    return run({source, target}, {from, to}, options);
}

namespace {

struct Given {
    std::vector<WorkingMesh> working;
    std::vector<MatchModel> models;

    Given(const std::vector<TriangleMesh>& meshes, const std::vector<Points>& markers) {
        for (const TriangleMesh& mesh : meshes) working.push_back(shapes::working(mesh));
        for (std::size_t k = 0; k < meshes.size(); ++k) models.push_back({&working[k], markers[k]});
    }
};

} // namespace

Matched run(const std::vector<TriangleMesh>& models, const std::vector<Points>& markers, const MatchOptions& options) {
    const Given given(models, markers);
    Stopwatch watch;
    MatchSession session(given.models, options);
    while (session.step()) {
    }
    Matched matched{session.result(), 0};
    matched.seconds = watch.lap();
    return matched;
}

ByPairs run_by_pairs(const std::vector<TriangleMesh>& models, const std::vector<Points>& markers) {
    const Given given(models, markers);
    Stopwatch watch;
    PairwiseMatch match(given.models);
    const auto all = [&] {
        for (std::size_t k = 0; k < models.size(); ++k)
            if (match.positions(static_cast<int>(k)).rows() == 0) return false;
        return true;
    };
    while (!all() && match.step()) {
    }
    MatchResult composed = match.result();
    while (match.step()) {
    }
    Matched projected{match.result(), 0};
    projected.seconds = watch.lap();
    return {std::move(composed), std::move(projected)};
}

Error error(const SkinSet& skins, const TriangleMesh& source, const TriangleMesh& target, int from, int to) {
    const TriangleMesh skin = skins.mesh(from), other = skins.mesh(to);
    const SurfacePlaces samples = sample_surface(skin, 20000);
    const Points here = samples.on(skin), there = samples.on(other);
    const TriangleTree tree(source);
    const double D = diagonal(target.points);
    std::vector<double> errors;
    double sum = 0;
    for (Eigen::Index i = 0; i < here.rows(); ++i) {
        const auto at = tree.nearest(here.row(i));
        const auto corner = [&](const TriangleMesh& mesh, int k) -> RowVector3d { return mesh.points.row(mesh.triangles(at.triangle, k)); };
        Eigen::Matrix<double, 3, 2> sides;
        sides << (corner(source, 1) - corner(source, 0)).transpose(), (corner(source, 2) - corner(source, 0)).transpose();
        const Eigen::Vector2d w = sides.colPivHouseholderQr().solve(at.point - corner(source, 0).transpose());
        const RowVector3d truth = (1 - w.sum()) * corner(target, 0) + w[0] * corner(target, 1) + w[1] * corner(target, 2);
        errors.push_back((truth - there.row(i)).norm() / D);
        sum += errors.back();
    }
    return {sum / static_cast<double>(errors.size()), *std::max_element(errors.begin(), errors.end())};
}

std::string figures(const Matched& matched) {
    const MatchReport& r = matched.result.report;
    std::ostringstream line;
    line.precision(3);
    line << matched.result.skins.vertex_count() << " vertices, " << matched.seconds << " s (start " << r.seconds.start << ", carry " << r.seconds.carry << ", fine " << r.seconds.fine << ", edges "
         << r.seconds.connectivity << ", report " << r.seconds.report << "), skin to model " << r.skins[1].distances.mean_there << ", back " << r.skins[1].distances.mean_back << ", 99 % " << r.skins[1].distances.most
         << "; source's skin " << r.skins[0].distances.mean_there << ", " << r.skins[0].distances.mean_back << ", " << r.skins[0].distances.most << "; marker error " << r.marker_error << ", folds " << r.skins[0].folds << " and "
         << r.skins[1].folds << ", crossings " << r.skins[0].crossings << " and " << r.skins[1].crossings << ", flipped " << r.skins[1].flipped << ", start " << (r.skins[1].bent ? "bent" : "similar") << " (flatness "
         << r.flatness << "), edges +" << r.connectivity.splits << " -" << r.connectivity.collapses << " x" << r.connectivity.swaps;
    for (const MatchWarning& warning : r.warnings) line << ", " << warning.code << " " << warning.count;
    return line.str();
}

} // namespace pairs
