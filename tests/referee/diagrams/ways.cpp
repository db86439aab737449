#include "ways.hpp"

#include <algorithm>

#include "diagram_file.hpp"

namespace referee {
namespace {

class Ways {
public:
    explicit Ways(int dim) : dim_(dim) {}

    // Options by name and value; all but --bounds and --all are lines of the head.
    Way& add(const std::string& filter, const std::vector<std::pair<std::string, std::string>>& options) {
        Way way;
        way.name = filter;
        way.arguments = {"--filter", filter};
        way.says = {{"filter", filter}};
        way.top = dim_ - 1;
        for (const auto& [option, value] : options) {
            way.name += " --" + option + (value.empty() ? "" : " " + value);
            way.arguments.push_back("--" + option);
            if (!value.empty()) way.arguments.push_back(value);
            way.says.emplace_back(option, value);
        }
        all_.push_back(way);
        return all_.back();
    }
    Way& on_mesh(const std::string& filter, std::vector<std::pair<std::string, std::string>> options,
                 double ratio_most) {
        Way& way = add(filter, options);
        way.ratio_most = ratio_most;
        way.has_mesh = way.has_cycles = true;
        way.inputs_first = filter == "complete" || filter == "tight";
        return way;
    }
    std::vector<Way> take() { return all_; }

private:
    int dim_;
    std::vector<Way> all_;
};

}  // namespace

std::vector<Way> ways_to_persist(int dim, std::size_t k, double width, Random& random) {
    Ways ways(dim);
    const double tau = std::round(10 * random.between(dim > 3 ? 3.2 : 2.3, 5)) / 10;
    const double goal = std::round(10 * random.between(dim > 3 ? 2.2 : 1.8, 4)) / 10;
    const double standard = dim < 4 ? 2.5 : 3.08;
    const std::string tau_text = exact_text(tau), k_text = std::to_string(k);
    const std::string from = exact_text(width * random.between(0.05, 0.3)),
                      to = exact_text(width * random.between(0.35, 1));
    const std::string seed = std::to_string(1 + random.below(1000));
    const auto neighbours = [&](double t, bool mean) {
        const double s = mean && k > 1 ? std::sqrt(static_cast<double>(k) / static_cast<double>(k - 1)) : 1;
        return k == 1 ? std::sqrt(2 + t) : std::sqrt(2 + s * (2 + t));
    };
    ways.on_mesh("complete", {{"bounds", ""}}, std::sqrt(2 + standard));
    ways.on_mesh("complete", {{"whole-cells", ""}, {"bounds", ""}}, std::sqrt(2 + standard));
    ways.on_mesh("complete", {{"seed", seed}, {"max-degree", "0"}}, std::sqrt(2 + standard)).top = 0;
    ways.on_mesh("complete", {{"ratio", exact_text(goal)}, {"bounds", ""}}, goal);
    ways.on_mesh("complete",
                 {{"ratio", "4"}, {"focus", dim > 3 ? "2" : "1.6"}, {"from", from}, {"to", to}, {"bounds", ""}}, 4);
    ways.on_mesh("complete", {{"method", "svr"}, {"tau", tau_text}, {"bounds", ""}}, std::sqrt(2 + tau));
    ways.on_mesh("complete", {{"method", "svr"}, {"tau", tau_text}, {"values", "thesis"}, {"bounds", ""}}, tau);
    ways.on_mesh("complete", {{"method", "netmesh"}, {"finish", ""}, {"all", ""}, {"bounds", ""}}, 0);
    if (dim == 2) ways.on_mesh("complete", {{"method", "refine"}, {"bounds", ""}}, std::sqrt(2 + standard));
    ways.on_mesh("basic", {{"seed", seed}, {"bounds", ""}}, 0);
    ways.on_mesh("basic", {{"tau", tau_text}, {"values", "thesis"}, {"bounds", ""}}, 0);
    for (const std::string filter : {"knn", "kdistance"}) {
        const bool mean = filter == "kdistance";
        const Reference reference = mean ? Reference::k_distance : Reference::kth;
        for (const bool thesis : {false, true}) {
            std::vector<std::pair<std::string, std::string>> options = {{"k", k_text}, {"bounds", ""}};
            if (thesis) options.insert(options.end(), {{"values", "thesis"}, {"tau", tau_text}});
            Way& way = ways.on_mesh(filter, options, thesis ? 0 : neighbours(standard, mean));
            way.k = k;
            way.inputs_first = k == 1;
            way.reference = reference;
        }
    }
    ways.on_mesh("tight", {{"eps", "0.5"}, {"bounds", ""}}, 1.5).over_refines = true;
    if (dim == 2)
        ways.on_mesh("tight", {{"eps", "0.3"}, {"tau", tau_text}, {"values", "thesis"}, {"bounds", ""}}, 0)
            .over_refines = true;
    Way& scales = ways.add("scales", {{"theta", "0.1"}, {"eps", "0.5"}, {"bounds", ""}});
    scales.ratio_most = 1.3 * 1.5;
    scales.over_refines = true;
    scales.has_cycles = true;
    for (const std::string theta : {"0.1", "0.05"}) {
        std::vector<std::pair<std::string, std::string>> options = {
            {"theta", theta}, {"ratio", theta == "0.1" ? "2" : "2.6"}, {"bounds", ""}};
        Way& way = ways.add("scales", options);
        way.ratio_most = theta == "0.1" ? 2 : 2.6;
        way.has_cycles = true;
    }
    for (const bool zero : {false, true}) {
        Way& way = zero ? ways.add("alpha", {{"all", ""}}) : ways.add("alpha", {{"bounds", ""}});
        way.promise = Promise::exact;
        way.has_mesh = true;
        way.ratio_most = 1;
    }
    for (const int top : {1, dim}) {
        for (const std::string filter : {"cech", "rips"}) {
            Way& way = ways.add(filter, {{"max-degree", std::to_string(top)}});
            way.promise = Promise::near;
            way.ratio_most = 1;
            way.top = top;
            way.reference = filter == "rips" ? Reference::rips : Reference::offsets;
            way.has_cycles = filter == "rips";
        }
    }
    for (const std::string filter : {"barycentric-cech", "barycentric-rips"})
        for (const bool thesis : {false, true}) {
            if (thesis && filter == "barycentric-cech") continue;
            std::vector<std::pair<std::string, std::string>> options = {{"k", k_text}, {"max-degree", "1"}};
            if (thesis) options.emplace_back("values", "thesis");
            Way& way = ways.add(filter, options);
            way.k = k;
            way.reference = Reference::kth;
            way.top = 1;
            way.promise = Promise::near;
            way.ratio_most = filter == "barycentric-cech" ? 1 : std::pow(2, thesis ? 0.5 : 0.25);
        }
    Way& fit = ways.on_mesh("complete", {{"fit", ""}, {"memory", "131072"}, {"bounds", ""}}, 0);
    fit.arguments.insert(fit.arguments.end(), {"--from", from, "--to", to});
    // The file says which scales were chosen, not how.
    Way& chosen = ways.on_mesh("complete", {{"focus", "auto"}, {"longer-than", "1.2"}, {"memory", "524288"}},
                               std::sqrt(2 + standard));
    chosen.says = {{"filter", "complete"}, {"bounds", ""}};
    return ways.take();
}

}  // namespace referee
