#include "limbs.h"

#include "deform/handles.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <sstream>

namespace limbs {

using namespace lissom;

std::vector<Limb> all() {
    return {{"octopus", "arm 0", {"arm0_1", "arm0_2", "arm0_3", "arm0_4", "arm0_5"}, true},
            {"octopus", "arm 2", {"arm2_1", "arm2_2", "arm2_3", "arm2_4", "arm2_5"}, true},
            {"octopus", "arm 5", {"arm5_1", "arm5_2", "arm5_3", "arm5_4", "arm5_5"}, true},
            {"horse", "fore leg", {"fleg1.L", "fleg2.L", "fleg3.L", "fleg4.L"}},
            {"horse", "hind leg", {"hleg1.L", "hleg2.L", "hleg3.L", "hleg4.L"}},
            {"horse", "neck", {"spine3", "neck1", "neck2"}},
            {"horse", "tail", {"tail1", "tail2", "tail3"}, true},
            {"cactus", "trunk", {"trunk0", "trunk1", "trunk2"}},
            {"cactus", "left arm", {"armL1", "armL2", "armL3"}, true},
            {"cactus", "right arm", {"armR1", "armR2", "armR3"}, true},
            {"critter", "arm", {"arm1.L", "arm2.L", "arm3.L"}, true},
            {"critter", "leg", {"leg1.L", "leg2.L", "leg3.L"}},
            {"critter", "tail", {"tail1", "tail2", "tail3"}, true},
            {"loops4", "a", {"a0", "a1", "a2", "a3"}},
            {"loops4", "b", {"b0", "b1", "b2", "a3"}},
            {"loops4", "c", {"c0", "c1", "c2"}},
            {"loops4", "f", {"f0", "f1", "f2", "f3"}}};
}

double Bone::along(const Vector3d& p) const { return (b - a).squaredNorm() > 0 ? std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) : 0; }

double Bone::distance(const Vector3d& p) const {
    const double u = along(p);
    return (a + u * (b - a) - p).norm() - ((1 - u) * ra + u * rb);
}

double error(const std::vector<Bone>& bones, const Vector3d& p) {
    double least = INFINITY;
    for (const Bone& bone : bones) {
        const double u = bone.along(p);
        least = std::min(least, (bone.a + u * (bone.b - bone.a) - p).norm() / ((1 - u) * bone.ra + u * bone.rb));
    }
    return least;
}

std::vector<Bone> Creature::bones(const Limb& limb) const {
    std::vector<Bone> found;
    for (std::size_t i = 0; i + 1 < limb.joints.size(); ++i)
        for (const NamedBone& named : skeleton)
            if (named.a == limb.joints[i] && named.b == limb.joints[i + 1]) found.push_back(named.bone);
    return found;
}

std::vector<Bone> Creature::others(const Limb& limb) const {
    std::vector<Bone> found;
    for (const NamedBone& named : skeleton) {
        bool own = false;
        for (std::size_t i = 0; i + 1 < limb.joints.size(); ++i) own |= named.a == limb.joints[i] && named.b == limb.joints[i + 1];
        if (!own) found.push_back(named.bone);
    }
    return found;
}

const Creature& creature(const std::string& name) {
    static std::map<std::string, Creature> read;
    if (const auto known = read.find(name); known != read.end()) return known->second;
    Creature& made = read[name];
    made.mesh = handles::shared_model("creatures/" + name + ".ply");
    if (made.mesh.vertex_count() == 0) {
        MESSAGE("skipped: there is no shared/data/creatures/" << name << ".ply here");
        return made;
    }
    made.working = std::make_shared<WorkingMesh>(shapes::working(made.mesh));
    made.surface = std::make_shared<CurveSurface>(made.working);
    const char* given = std::getenv("LISSOM_SHARED");
    std::string text;
    for (const std::string& root : {std::string(given ? given : "../shared"), std::string("../../../shared"), std::string("../../shared")}) {
        std::ifstream file(root + "/data/creatures/" + name + ".skeleton.json");
        std::stringstream all;
        all << file.rdbuf();
        if (text.empty()) text = all.str();
    }
    std::map<std::string, Eigen::Vector4d> joints;
    const std::regex joint(R"re("([\w.]+)":\s*\[([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+)\])re");
    for (std::sregex_iterator m(text.begin(), text.end(), joint), end; m != end; ++m)
        joints[(*m)[1]] = {std::stod((*m)[2]), std::stod((*m)[3]), std::stod((*m)[4]), std::stod((*m)[5])};
    const std::regex bone(R"re(\["([\w.]+)",\s*"([\w.]+)"\])re");
    for (std::sregex_iterator m(text.begin(), text.end(), bone), end; m != end; ++m) {
        const Eigen::Vector4d a = joints.at((*m)[1]), b = joints.at((*m)[2]);
        made.skeleton.push_back({(*m)[1], (*m)[2], {a.head<3>(), b.head<3>(), a[3], b[3]}});
    }
    return made;
}

Eigen::Vector2d View::to_screen(const Vector3d& p) const { return {(p - centre).dot(right) / pixel, (p - centre).dot(up) / pixel}; }

View view_of(const TriangleMesh& mesh, const Vector3d& forward) {
    View view;
    view.forward = forward.normalized();
    view.right = view.forward.cross(std::abs(view.forward.y()) > 0.9 ? Vector3d(0, 0, 1) : Vector3d(0, 1, 0)).normalized();
    view.up = view.right.cross(view.forward);
    view.centre = (mesh.points.colwise().minCoeff() + mesh.points.colwise().maxCoeff()).transpose() / 2;
    view.pixel = diagonal(mesh.points) / 900;
    return view;
}

Stroke drawn(const View& view, const std::vector<Vector3d>& through, double noise, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> trembling(0, noise > 0 ? noise : 1);
    std::vector<Eigen::Vector2d> places;
    for (std::size_t i = 0; i + 1 < through.size(); ++i) {
        const Eigen::Vector2d a = view.to_screen(through[i]), b = view.to_screen(through[i + 1]);
        const int pieces = std::max(1, static_cast<int>(std::lround((b - a).norm() / 4)));
        for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) places.push_back(a + (b - a) * k / pieces);
    }
    Stroke stroke;
    const auto n = std::ssize(places);
    stroke.pixels.resize(n, 2);
    stroke.origins.resize(n, 3);
    stroke.directions.resize(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        if (noise > 0) places[i] += Eigen::Vector2d(trembling(random), trembling(random));
        stroke.pixels.row(i) = places[i].transpose();
        stroke.origins.row(i) = (view.centre + view.pixel * (places[i].x() * view.right + places[i].y() * view.up - 2000 * view.forward)).transpose();
        stroke.directions.row(i) = view.forward.transpose();
    }
    return stroke;
}

Stroke along(const Creature& creature, const Limb& limb, double noise, std::uint64_t seed) {
    const std::vector<Bone> bones = creature.bones(limb);
    std::vector<Vector3d> through{bones.front().a};
    for (const Bone& bone : bones) through.push_back(bone.b);
    View best;
    double most = -1;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const View view = view_of(creature.mesh, Vector3d(x, y, z));
                double seen = 0, alone = 0, all = 0, length = 0;
                for (const Bone& bone : bones) {
                    for (int k = 0; k <= 8; ++k) {
                        const Vector3d p = bone.a + (bone.b - bone.a) * k / 8.0;
                        const double r = bone.ra + (bone.rb - bone.ra) * k / 8.0, back = 10 * diagonal(creature.mesh.points);
                        const auto hits = creature.surface->tree().hits(creature.working->to_working(Vector3d(p - back * view.forward)), view.forward);
                        seen += !hits.empty() && back - hits.front().depth * creature.working->scale < 2 * r ? 1 : 0;
                        alone += hits.size() == 2 ? 1 : 0;
                        all += 1;
                    }
                    length += (view.to_screen(bone.b) - view.to_screen(bone.a)).norm() * view.pixel / (bone.b - bone.a).norm();
                }
                const double worth = 3 * seen / all + 0.5 * alone / all + length / static_cast<double>(bones.size());
                if (worth > most) {
                    most = worth;
                    best = view;
                }
            }
    return drawn(best, through, noise, seed);
}

} // namespace limbs
