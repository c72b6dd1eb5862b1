#include "figures.h"

#include "lissom/isoline/triangle_frames.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/similarity.h"

#include <doctest/doctest.h>

#include <Eigen/SVD>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

namespace figures {
namespace {

using namespace lissom;

std::vector<std::string> roots() {
    const char* given = std::getenv("LISSOM_SHARED"); // else from the build directory, the sources or the repository's root
    return {given ? given : "../shared", "../../../shared", "../../shared"};
}

Eigen::Vector3d normal(const Triangles& T, const Points& p, int t) {
    const Eigen::Vector3d a = p.row(T(t, 0)), b = p.row(T(t, 1)), c = p.row(T(t, 2));
    return (b - a).cross(c - a).normalized();
}

} // namespace

double stretch_rms(const TriangleMesh& rest, const Points& moved) {
    const Eigen::VectorXd areas = triangle_areas(rest);
    const auto gradients = triangle_gradients(rest, moved);
    double sum = 0;
    for (int t = 0; t < rest.triangle_count(); ++t) { // the third singular value, of the normal, is 1
        const Eigen::Vector3d s = Eigen::JacobiSVD<Eigen::Matrix3d>(gradients[t]).singularValues();
        sum += areas[t] * (s.array() - 1).square().sum();
    }
    return std::sqrt(sum / areas.sum());
}

double crease(const TriangleMesh& rest, const Points& moved) {
    double worst = 0;
    const auto sides = half_edges(rest);
    for_each_edge(sides, [&](auto first, auto last) {
        if (last - first != 2) return;
        const int s = first->triangle, t = (first + 1)->triangle;
        if (normal(rest.triangles, rest.points, s).dot(normal(rest.triangles, rest.points, t)) < 1 - 1e-9) return;
        worst = std::max(worst, std::acos(std::clamp(normal(rest.triangles, moved, s).dot(normal(rest.triangles, moved, t)), -1.0, 1.0)));
    });
    return worst * 57.29577951308232;
}

double normals_apart(const TriangleMesh& a, const Points& b) {
    const Points n = vertex_normals(a), m = vertex_normals({b, a.triangles});
    double sum = 0;
    for (Eigen::Index v = 0; v < n.rows(); ++v) sum += std::acos(std::clamp(n.row(v).dot(m.row(v)), -1.0, 1.0));
    return sum / static_cast<double>(n.rows()) * 57.29577951308232;
}

std::vector<PersonPose> poses_of_people() {
    return {{"human/body_male", "human/body_male_walk", "human/body_female"},
            {"human/body_male", "human/body_male_walk", "human/body_heavy"},
            {"human/body_female", "human/body_female_armsup", "human/body_male"},
            {"human/body_female", "human/body_female_armsup", "human/body_heavy"}};
}

TriangleMesh shared(const std::string& name) {
    const TriangleMesh mesh = handles::shared_model(name + ".ply");
    if (mesh.vertex_count() == 0) MESSAGE("skipped: there is no shared/data/" << name << ".ply here");
    return mesh;
}

std::map<std::string, Joint> joints(const std::string& name) {
    std::map<std::string, Joint> found;
    for (const std::string& root : roots()) {
        std::ifstream file(root + "/data/" + name + ".skeleton.json");
        std::stringstream text;
        text << file.rdbuf();
        const std::string all = text.str();
        const std::regex of_creature(R"re("([\w.]+)":\s*\[([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+)\])re");
        const std::regex of_person(R"re("name":\s*"([\w.]+)"[^}]*?"head":\s*\[([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+)\])re");
        for (const bool person : {false, true}) {
            const std::regex& form = person ? of_person : of_creature;
            for (std::sregex_iterator m(all.begin(), all.end(), form), end; m != end; ++m)
                found[(*m)[1]] = {{std::stod((*m)[2]), std::stod((*m)[3]), std::stod((*m)[4])}, person ? 0 : std::stod((*m)[5])};
        }
        if (!found.empty()) break;
    }
    return found;
}

std::vector<int> ball(const Points& points, const Eigen::Vector3d& centre, double radius) {
    std::vector<int> inside;
    for (int v = 0; v < points.rows(); ++v)
        if ((points.row(v).transpose() - centre).norm() < radius) inside.push_back(v);
    return inside;
}

std::vector<DeformHandle> of_person(const TriangleMesh& mesh, const std::string& name, bool more) {
    const auto at = joints(name);
    const double tall = mesh.points.col(1).maxCoeff() - mesh.points.col(1).minCoeff();
    std::vector<DeformHandle> held;
    const struct {
        const char* joint;
        double radius; // of the height
    } balls[] = {{"wrist.L", 0.05}, {"wrist.R", 0.05}, {"foot.L", 0.055}, {"foot.R", 0.055}, {"head", 0.07}, {"spine05", 0.1}};
    for (const auto& [joint, radius] : balls) held.push_back({.is_point = false, .vertices = ball(mesh.points, at.at(joint).at, radius * tall)});
    // Beyond wrist and ankle a hand and a foot move as one.
    for (int v = 0; v < mesh.vertex_count(); ++v)
        for (int h = 0; h < 4; ++h) {
            const Eigen::Vector3d p = mesh.points.row(v), j = at.at(balls[h].joint).at;
            const bool beyond = h < 2 ? std::abs(p[0]) > std::abs(j[0]) && p[0] * j[0] > 0 && (p - j).norm() < 0.16 * tall : p[1] < j[1] && p[0] * j[0] > 0;
            if (beyond && (p - j).norm() >= balls[h].radius * tall) held[static_cast<std::size_t>(h)].vertices.push_back(v);
        }
    if (more)
        for (const char* joint : {"lowerarm01.L", "lowerarm01.R", "lowerleg01.L", "lowerleg01.R"}) {
            int nearest = 0;
            (mesh.points.rowwise() - at.at(joint).at.transpose()).rowwise().norm().minCoeff(&nearest);
            held.push_back({.is_point = true, .vertices = {nearest}});
        }
    return held;
}

std::vector<Eigen::Affine3d> motions(const std::vector<DeformHandle>& held, const Points& from, const Points& to) {
    std::vector<Eigen::Affine3d> maps;
    for (const DeformHandle& handle : held) {
        Points a(std::ssize(handle.vertices), 3), b = a;
        for (std::size_t k = 0; k < handle.vertices.size(); ++k) {
            a.row(static_cast<Eigen::Index>(k)) = from.row(handle.vertices[k]);
            b.row(static_cast<Eigen::Index>(k)) = to.row(handle.vertices[k]);
        }
        if (handle.is_point) {
            maps.emplace_back(Eigen::Translation3d((b - a).row(0).transpose()));
            continue;
        }
        Similarity map = fit_similarity(a, b);
        map.translation += map.scale * map.rotation * a.colwise().mean().transpose() - map.rotation * a.colwise().mean().transpose();
        map.scale = 1;
        maps.push_back(map.affine());
    }
    return maps;
}

} // namespace figures
