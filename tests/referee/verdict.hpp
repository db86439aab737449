// What the referee finds in a mesh.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace referee {

struct Fault {
    std::string promise;  // the one that is broken: "delaunay", "quality" ...
    std::string text;
};

struct Verdict {
    std::vector<Fault> faults;
    double worst_ratio = 0;    // of the cells that quality is asked of
    double sampled_ratio = 0;  // the same by sampling

    bool good() const { return faults.empty(); }
    bool blames(const std::string& promise) const {
        for (const Fault& fault : faults)
            if (fault.promise == promise) return true;
        return false;
    }
    // One of a kind is enough.
    void add(const std::string& promise, const std::string& text) {
        if (!blames(promise)) faults.push_back({promise, text});
    }
};

inline std::string number_text(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", x);
    return text;
}
inline std::string faults_text(const Verdict& verdict) {
    std::string text;
    for (const Fault& fault : verdict.faults) text += fault.promise + ": " + fault.text + "; ";
    return text;
}
template <class Count> std::string count_text(Count n) { return std::to_string(n); }

}  // namespace referee
