// How well garments fit and parts are carried, on real bodies and heads whose vertices correspond; each figure is printed.

#include "lissom/wear/blend_session.h"
#include "lissom/wear/dress_session.h"

#include "../isoline/figures.h"
#include "../match/pairs.h"
#include "shapes.h"

#include "lissom/match/folds.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_paths.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using figures::shared;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

/// Mean distance of a garment from what was designed for the body, and along the cloth's normal.
struct Apart {
    double all = 0, normal = 0;
};
Apart apart(const Points& worn, const TriangleMesh& truth) {
    const Points normals = lissom::vertex_normals(truth), off = worn - truth.points;
    return {off.rowwise().norm().mean(), off.cwiseProduct(normals).rowwise().sum().cwiseAbs().mean()};
}

} // namespace

TEST_CASE("shirts, pants and skirts of three bodies fit the two others, and nothing of them is inside") {
    const std::vector<std::string> who{"female", "male", "heavy"};
    std::vector<TriangleMesh> bodies;
    for (const std::string& name : who) bodies.push_back(shared("human/body_" + name));
    for (const TriangleMesh& body : bodies)
        if (body.vertex_count() == 0) return;
    for (const std::string kind : {"shirt", "pants", "skirt"}) {
        double all = 0, normal = 0, worst = 0, seconds = 0;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) {
                if (a == b) continue;
                const TriangleMesh made = shared("human/" + kind + "_" + who[a]), truth = shared("human/" + kind + "_" + who[b]);
                REQUIRE(made.vertex_count() > 0);
                const lissom::WorkingMesh garment = shapes::working(made), model = shapes::working(bodies[b]);
                lissom::DressSession session(garment, bodies[a].triangles, bodies[a].points, bodies[b].points, &model);
                while (session.step()) {
                }
                const lissom::Dressed worn = session.dress();
                const Apart error = apart(worn.positions, truth);
                MESSAGE(kind << ", " << who[a] << " -> " << who[b] << ": " << 100 * error.all << " cm, along the normal " << 100 * error.normal << " cm, inside " << worn.before.vertices << " and "
                             << worn.before.face_centres << " before, " << worn.after.vertices << " and " << worn.after.face_centres << " after " << worn.rounds << " rounds; prepared in "
                             << session.seconds().prepare << " s, dressed in " << session.seconds().dress << " s");
                CHECK(worn.after.none());
                CHECK(worn.warnings.empty());
                all += error.all / 6, normal += error.normal / 6, worst = std::max(worst, error.normal);
                seconds += session.seconds().prepare + session.seconds().dress;
            }
        MESSAGE(kind << ": mean " << 100 * all << " cm, along the normal " << 100 * normal << " (at most " << 100 * worst << ") cm, six in " << seconds << " s");
        const bool is_wide = kind == "skirt";
        CHECK(all < (is_wide ? 0.016 : 0.013));
        CHECK(worst < (is_wide ? 0.010 : 0.0035));
    }
}

TEST_CASE("a shoe fits other feet") {
    const TriangleMesh from = shared("human/foot_female");
    if (from.vertex_count() == 0) return;
    // A shoe: a smooth skin around the whole foot, toes together.
    TriangleMesh shoe = shapes::icosphere(4);
    const Eigen::RowVector3d low = from.points.colwise().minCoeff(), high = from.points.colwise().maxCoeff();
    for (Eigen::Index v = 0; v < shoe.points.rows(); ++v) shoe.points.row(v) = 0.5 * (low + high) + 0.75 * shoe.points.row(v).cwiseProduct(high - low);
    const lissom::WorkingMesh garment = shapes::working(shoe);
    for (const std::string who : {"male", "child"}) {
        const TriangleMesh to = shared("human/foot_" + who);
        const lissom::WorkingMesh model = shapes::working(to);
        lissom::DressSession session(garment, from.triangles, from.points, to.points, &model);
        while (session.step()) {
        }
        // As it is, and tighter than the foot.
        const lissom::Dressed worn = session.dress(), tight = session.dress(-0.008);
        MESSAGE("shoe, female -> " << who << ": inside " << worn.before.vertices << " before; tighter by 8 mm " << tight.before.vertices << " and " << tight.before.face_centres << ", after "
                                   << tight.rounds << " rounds " << tight.after.vertices << " and " << tight.after.face_centres);
        CHECK(worn.before.vertices < 10);
        CHECK(worn.after.none());
        CHECK(tight.before.vertices > 0);
        CHECK(tight.after.none());
        const double grown = lissom::diagonal(worn.positions) / lissom::diagonal(shoe.points), foot = lissom::diagonal(to.points) / lissom::diagonal(from.points);
        CHECK(grown == doctest::Approx(foot).epsilon(0.1));
    }
}

TEST_CASE("a nose is carried with all of its height and no new folds") {
    const TriangleMesh onto = shared("human/head_female");
    const auto marks = pairs::landmarks("human/head_regions");
    if (onto.vertex_count() == 0 || marks.empty()) return;
    const int tip = marks.at("nose_tip"), glabella = marks.at("glabella");
    const auto graph = lissom::edge_graph(onto);
    const std::vector<int> start{tip};
    const double reach = 0.45 * (onto.points.row(tip) - onto.points.row(glabella)).norm();
    const auto paths = lissom::shortest_paths(graph, start);
    lissom::PartSpec part{.from = 1, .vertices = {}};
    for (int v = 0; v < onto.vertex_count(); ++v)
        if (paths.distance[static_cast<std::size_t>(v)] < reach) part.vertices.push_back(v);
    const auto around = lissom::neighbouring_triangles(onto);
    lissom::IntersectionFinder finder(onto);
    const int folds = lissom::count_folds(onto, around), crossings = static_cast<int>(finder.find(onto.points).triangles.size());
    for (const std::string who : {"troll", "male", "elf", "child", "heavy"}) {
        const TriangleMesh from = shared("human/head_" + who);
        lissom::BlendSession session(onto.triangles, {onto.points, from.points}, {part});
        while (session.step()) {
        }
        const lissom::Blended found = session.blend(Eigen::Vector2d(1, 0));
        const TriangleMesh result{found.positions, onto.triangles};
        // The height by its own size: of the tip over the part's border, in widths of the border.
        const auto height = [&](const Points& points) {
            Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
            std::vector<int> rim;
            for (const int v : part.vertices)
                if (paths.distance[static_cast<std::size_t>(v)] > 0.9 * reach) rim.push_back(v), middle += points.row(v);
            middle /= static_cast<double>(rim.size());
            double spread = 0;
            for (const int v : rim) spread += (points.row(v) - middle).squaredNorm();
            return (points.row(tip) - middle).norm() / std::sqrt(spread / static_cast<double>(rim.size()));
        };
        const int folded = lissom::count_folds(result, around), met = static_cast<int>(finder.find(result.points).triangles.size());
        MESSAGE("nose of " << who << ": " << 100 * height(result.points) / height(from.points) << " % of its height, folds " << folds << " -> " << folded << ", triangles that cross " << crossings
                           << " -> " << met << ", factored in " << session.seconds().factor << " s, set in in " << session.seconds().blend << " s");
        CHECK(height(result.points) == doctest::Approx(height(from.points)).epsilon(1e-6));
        CHECK(folded <= folds);
        CHECK(met <= crossings + 2);
    }
}

TEST_CASE("bodies are made to measure") {
    std::vector<Points> bodies;
    TriangleMesh first;
    for (const std::string who : {"female", "male", "heavy"}) {
        TriangleMesh body = shared("human/body_" + who);
        if (body.vertex_count() == 0) return;
        bodies.push_back(body.points);
        if (bodies.size() == 1) first = std::move(body);
    }
    // Around the navel.
    const auto marks = pairs::landmarks("human/body_regions");
    lissom::Measure tall, waist;
    waist.kind = lissom::Measure::Kind::section, waist.hull = true, waist.vertex = marks.at("navel");
    lissom::BlendSession session(first.triangles, bodies, {});
    const Eigen::Vector3d truth(0.5, 0.3, 0.2);
    std::vector<lissom::Measure> asked{tall, waist};
    const std::vector<double> wanted = session.blend(truth, asked).reached;
    for (std::size_t m = 0; m < 2; ++m) asked[m].wanted = wanted[m];
    const lissom::Blended found = session.blend(Eigen::Vector3d(1, 0, 0), asked);
    MESSAGE("height " << found.reached[0] << " of " << wanted[0] << " m, waist " << found.reached[1] << " of " << wanted[1] << " m in " << found.iterations << " rounds, " << session.seconds().measure
                      << " s; weights " << found.weights.transpose());
    CHECK(found.reached[0] == doctest::Approx(wanted[0]).epsilon(1e-4));
    CHECK(found.reached[1] == doctest::Approx(wanted[1]).epsilon(1e-4));
    CHECK((found.weights - truth).norm() < 1e-2); // two measures decide three weights that sum to 1
}
