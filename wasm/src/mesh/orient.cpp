#include "lissom/mesh/orient.h"

#include <cmath>
#include <vector>

namespace lissom {

namespace {

/// A number as a sum of doubles that do not overlap, smallest first: exact whatever is added or multiplied.
using Expansion = std::vector<double>;

/// Knuth: sum + error = a + b exactly.
void two_sum(double a, double b, double& sum, double& error) {
    sum = a + b;
    const double b_virtual = sum - a;
    error = (a - (sum - b_virtual)) + (b - b_virtual);
}

/// Grow-expansion (Shewchuk, theorem 10).
void add(Expansion& e, double b) {
    double carry = b;
    for (double& part : e) {
        double sum, error;
        two_sum(carry, part, sum, error);
        part = error;
        carry = sum;
    }
    e.push_back(carry);
}

Expansion plus(Expansion e, const Expansion& f) {
    for (const double part : f) add(e, part);
    return e;
}

Expansion times(const Expansion& e, const Expansion& f) {
    Expansion result;
    for (const double x : e)
        for (const double y : f) {
            const double product = x * y;
            add(result, std::fma(x, y, -product)); // the rounding error, exactly
            add(result, product);
        }
    return result;
}

Expansion minus(Expansion e) {
    for (double& part : e) part = -part;
    return e;
}

Expansion difference(double a, double b) {
    Expansion result;
    add(result, a);
    add(result, -b);
    return result;
}

int sign(const Expansion& e) {
    for (auto part = e.rbegin(); part != e.rend(); ++part)
        if (*part != 0) return *part > 0 ? 1 : -1;
    return 0;
}

constexpr double k_epsilon = 0x1p-53;

} // namespace

int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
    const Eigen::Vector3d p = a - d, q = b - d, r = c - d;
    const double qr = q.x() * r.y(), rq = r.x() * q.y(), rp = r.x() * p.y(), pr = p.x() * r.y(), pq = p.x() * q.y(), qp = q.x() * p.y();
    const double det = p.z() * (qr - rq) + q.z() * (rp - pr) + r.z() * (pq - qp);
    const double size = (std::abs(qr) + std::abs(rq)) * std::abs(p.z()) + (std::abs(rp) + std::abs(pr)) * std::abs(q.z()) + (std::abs(pq) + std::abs(qp)) * std::abs(r.z());
    const double bound = (7 + 56 * k_epsilon) * k_epsilon * size; // o3derrboundA
    if (det > bound) return -1;
    if (det < -bound) return 1;

    Expansion x[3], y[3], z[3];
    int k = 0;
    for (const Eigen::Vector3d* corner : {&a, &b, &c}) {
        x[k] = difference(corner->x(), d.x());
        y[k] = difference(corner->y(), d.y());
        z[k++] = difference(corner->z(), d.z());
    }
    Expansion exact;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        exact = plus(exact, times(z[i], plus(times(x[j], y[l]), minus(times(x[l], y[j])))));
    }
    return -sign(exact);
}

int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
    const double det = left - right, bound = (3 + 16 * k_epsilon) * k_epsilon * (std::abs(left) + std::abs(right)); // ccwerrboundA
    if (det > bound) return 1;
    if (det < -bound) return -1;
    return sign(plus(times(difference(a.x(), c.x()), difference(b.y(), c.y())), minus(times(difference(a.y(), c.y()), difference(b.x(), c.x())))));
}

} // namespace lissom
