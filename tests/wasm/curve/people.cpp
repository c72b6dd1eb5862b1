#include "people.h"

#include "../isoline/figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>

namespace people {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

struct Bone {
    std::string parent;
    Vector3d head, tail;
};

std::map<std::string, Bone> bones_of(const std::string& person) {
    std::map<std::string, Bone> found;
    for (const std::string root : {"../shared", "../../shared", "../../../shared"}) {
        std::ifstream file(root + "/data/human/body_" + person + ".skeleton.json");
        std::stringstream text;
        text << file.rdbuf();
        const std::string all = text.str();
        const std::string three = R"re(\[\s*([-\d.e]+),\s*([-\d.e]+),\s*([-\d.e]+)\s*\])re";
        const std::regex form(R"re("name":\s*"([\w.-]+)",\s*"parent":\s*(?:null|"([\w.-]+)"),\s*"head":\s*)re" + three + R"re(,\s*"tail":\s*)re" + three);
        for (std::sregex_iterator m(all.begin(), all.end(), form), end; m != end; ++m) {
            const auto number = [&](int k) { return std::stod((*m)[k]); };
            found[(*m)[1]] = {(*m)[2], {number(3), number(4), number(5)}, {number(6), number(7), number(8)}};
        }
        if (!found.empty()) break;
    }
    return found;
}

/// Rotation vectors of bones, degrees: how the shared poses were made.
const std::map<std::string, std::map<std::string, Vector3d>>& turns() {
    static const std::map<std::string, std::map<std::string, Vector3d>> all{
        {"armsup", {{"upperarm01.L", {0, 0, 75}}, {"upperarm01.R", {0, 0, -75}}, {"lowerarm01.L", {-25, 0, 25}}, {"lowerarm01.R", {-25, 0, -25}}, {"neck01", {-12, 0, 0}}}},
        {"walk",
         {{"upperleg01.L", {-32, 0, 0}}, {"lowerleg01.L", {18, 0, 0}}, {"upperleg01.R", {24, 0, 0}}, {"lowerleg01.R", {38, 0, 0}}, {"upperarm01.L", {22, 0, -22}},
          {"upperarm01.R", {-28, 0, 22}}, {"lowerarm01.R", {-35, 0, 0}}, {"lowerarm01.L", {-12, 0, 0}}, {"spine03", {0, 10, 0}}, {"neck02", {0, -10, 0}}}}};
    return all;
}

} // namespace

std::vector<std::pair<std::string, std::string>> poses() { return {{"female", "armsup"}, {"male", "walk"}}; }

Person posed(const std::string& person, const std::string& pose) {
    Person result;
    const std::map<std::string, Bone> bones = bones_of(person);
    const lissom::TriangleMesh rest = figures::shared("human/body_" + person), moved = figures::shared("human/body_" + person + "_" + pose);
    if (bones.empty() || rest.vertex_count() == 0 || moved.vertex_count() == 0) return result;
    result.rest = rest;
    std::map<std::string, Eigen::Affine3d> world;
    const auto frame = [&](const auto& self, const std::string& name) -> Eigen::Affine3d {
        if (const auto known = world.find(name); known != world.end()) return known->second;
        const Bone& bone = bones.at(name);
        Eigen::Affine3d own = Eigen::Affine3d::Identity();
        if (const auto turn = turns().at(pose).find(name); turn != turns().at(pose).end()) {
            const Vector3d v = turn->second * std::numbers::pi / 180;
            own = Eigen::Translation3d(bone.head) * Eigen::AngleAxisd(v.norm(), v.normalized()) * Eigen::Translation3d(-bone.head);
        }
        return world[name] = (bone.parent.empty() ? Eigen::Affine3d::Identity() : self(self, bone.parent)) * own;
    };
    // The posed file stands on the ground: the hips, which no turn moves, tell how far it was lifted.
    const Vector3d hips = bones.at("root").tail;
    std::vector<double> lifts;
    for (int v = 0; v < rest.vertex_count(); ++v)
        if ((rest.points.row(v).transpose() - hips - Vector3d(0, 0.06, 0)).norm() < 0.13) lifts.push_back(moved.points(v, 1) - rest.points(v, 1));
    std::sort(lifts.begin(), lifts.end());
    const Vector3d lift(0, lifts[lifts.size() / 2], 0);
    result.posed = moved.points.rowwise() - lift.transpose();

    std::vector<std::vector<std::string>> chains{{"spine05", "spine04", "spine03", "spine02", "spine01", "neck01", "neck02", "head"}};
    for (const std::string side : {".L", ".R"}) chains.push_back({"upperarm01" + side, "upperarm02" + side, "lowerarm01" + side, "lowerarm02" + side, "wrist" + side});
    for (const std::string side : {".L", ".R"}) chains.push_back({"upperleg01" + side, "upperleg02" + side, "lowerleg01" + side, "lowerleg02" + side});
    for (const auto& chain : chains) {
        std::vector<Vector3d> at_rest, joints;
        std::vector<Matrix3d> rotations;
        for (const std::string& name : chain) {
            at_rest.push_back(bones.at(name).head);
            joints.push_back(frame(frame, name) * bones.at(name).head);
            rotations.push_back(world[name].linear());
        }
        at_rest.push_back(bones.at(chain.back()).tail);
        joints.push_back(world[chain.back()] * bones.at(chain.back()).tail);
        rotations.push_back(rotations.back());
        result.curves.push_back({.rest = posing::row_list(at_rest)});
        result.joints.push_back(joints);
        result.rotations.push_back(rotations);
    }
    result.curves.front().anchor = lissom::CurveEnd::start;
    for (const int arm : {1, 2}) result.links.push_back({arm, 0, 4.0 / 8});
    for (const int leg : {3, 4}) result.links.push_back({leg, 0, 0});
    return result;
}

std::vector<lissom::CurvePosture> postures(const Person& person, const lissom::CurveSession& session, bool twist) {
    const int count = static_cast<int>(person.curves.size());
    std::vector<lissom::CurvePosture> result(count);
    for (int c = 0; c < count; ++c) {
        const Eigen::Affine3d from_parent = session.parent_motions(result)[c]; // parents come first
        const lissom::Points world = posing::row_list(person.joints[c]);
        result[c].points = posing::mapped(world, from_parent.inverse());
        if (!twist) continue;
        lissom::EncodedCurveOptions options;
        options.radius.assign(person.joints[c].size(), 0.05);
        options.held = c == 0;
        const lissom::EncodedCurve curve(person.curves[c].rest, options);
        std::vector<double> t;
        for (std::size_t i = 0; i < person.joints[c].size(); ++i) t.push_back(static_cast<double>(i) / static_cast<double>(person.joints[c].size() - 1));
        std::vector<double> fine; // frames are carried in small steps
        const int steps = 100;
        for (std::size_t i = 0; i + 1 < t.size(); ++i)
            for (int k = 0; k < steps; ++k) fine.push_back(t[i] + (t[i + 1] - t[i]) * k / steps);
        fine.push_back(1);
        const std::vector<lissom::EncodedCurve::Across> none(fine.size(), {0, 1, 1});
        const lissom::CurvePosture plain{.points = world, .base = Eigen::Quaterniond(from_parent.linear())};
        const auto posed = curve.posed_frames(curve.posed_curve(plain), plain, fine, none);
        const auto rest = curve.rest_frames(fine);
        for (std::size_t i = 0; i < t.size(); ++i) {
            const auto& frame = posed[i * steps];
            const auto roll = [&](const Matrix3d& R) { // of a bone against the frame that points alone give
                const Vector3d v = R * rest[i * steps].axes.col(1);
                return std::atan2(v.dot(frame.axes.col(2)), v.dot(frame.axes.col(1))) * 180 / std::numbers::pi;
            };
            const double after = roll(person.rotations[c][i]), before = i > 0 ? roll(person.rotations[c][i - 1]) : after;
            result[c].twist.push_back((after + before) / 2);
        }
    }
    return result;
}

} // namespace people
