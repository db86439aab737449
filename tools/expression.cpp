#include "tools/expression.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/characters.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr std::size_t length_max = 4096;
constexpr int depth_max = 64;  // of parentheses and signs
constexpr std::uint64_t exponent_max = 64;

bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

class ExpressionParser {
public:
    explicit ExpressionParser(Expression* out) : out_(*out) {}

    std::string parse() {
        const bool good = sum() && (peek() == 0 || fault("an operator or the end is due, not " + seen()));
        return good ? "" : complaint_;
    }

private:
    using Code = Expression::Code;

    // The next character that is no blank; 0 at the end.
    char peek() {
        while (at_ < out_.text_.size() && out_.text_[at_] == ' ') at_++;
        return at_ < out_.text_.size() ? out_.text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        at_++;
        return true;
    }
    std::string seen() { return peek() == 0 ? "the end" : std::string("'") + peek() + "'"; }
    bool fault(const std::string& why) { return fault_at(at_, why); }
    bool fault_at(std::size_t at, const std::string& why) {
        if (complaint_.empty()) complaint_ = "column " + std::to_string(at + 1) + ": " + why;
        return false;
    }
    bool add(Code code, std::uint32_t index = 0, double number = 0) {
        out_.steps_.push_back({code, index, number});
        return true;
    }

    bool sum() {
        if (!product()) return false;
        for (;;) {
            if (take('+')) {
                if (!product() || !add(Code::add)) return false;
            } else if (take('-')) {
                if (!product() || !add(Code::subtract)) return false;
            } else {
                return true;
            }
        }
    }
    bool product() {
        if (!factor()) return false;
        for (;;) {
            if (take('*')) {
                if (!factor() || !add(Code::multiply)) return false;
            } else if (take('/')) {
                if (!factor() || !add(Code::divide)) return false;
            } else {
                return true;
            }
        }
    }
    bool factor() {
        if (++depth_ > depth_max) return fault("more than " + std::to_string(depth_max) + " levels");
        const bool minus = take('-');
        const bool good = minus || take('+') ? factor() && (!minus || add(Code::negate)) : power();
        depth_--;
        return good;
    }
    bool power() {
        if (!primary()) return false;
        if (!take('^')) return true;
        peek();
        const std::size_t begin = at_;
        while (at_ < out_.text_.size() && is_digit(out_.text_[at_])) at_++;
        std::uint64_t exponent;
        if (!parse_unsigned(out_.text_.substr(begin, at_ - begin), &exponent) || exponent > exponent_max)
            return fault_at(begin, "an exponent is a whole number from 0 to " + std::to_string(exponent_max));
        if (peek() == '^') return fault("a power of a power needs parentheses");
        return add(Code::power, static_cast<std::uint32_t>(exponent));
    }
    bool primary() {
        if (take('(')) return sum() && (take(')') || fault("')' is due, not " + seen()));
        const char c = peek();
        if (is_digit(c) || c == '.') return number();
        if (begins_name(c)) return name();
        return fault("a number, a coordinate, a function or '(' is due, not " + seen());
    }
    bool number() {
        const char* const begin = out_.text_.data() + at_;
        const char* next = begin;
        double value;
        if (parse_double(next, out_.text_.data() + out_.text_.size(), &value) != NumberKind::finite)
            return fault("not a finite number");
        at_ += static_cast<std::size_t>(next - begin);
        return add(Code::number, 0, value);
    }
    bool name() {
        const std::size_t begin = at_;
        while (at_ < out_.text_.size() && (begins_name(out_.text_[at_]) || is_digit(out_.text_[at_]))) at_++;
        const std::string name = out_.text_.substr(begin, at_ - begin);
        constexpr struct {
            const char* name;
            Code code;
            bool many;
        } functions[] = {{"sqrt", Code::root, false},
                         {"abs", Code::size, false},
                         {"min", Code::least, true},
                         {"max", Code::most, true}};
        for (const auto& function : functions)
            if (name == function.name) return arguments(name, function.code, function.many);
        constexpr char letters[] = "xyzw";
        std::uint32_t coordinate = 0;
        for (std::uint32_t i = 0; i < 4; i++)
            if (name.size() == 1 && name[0] == letters[i]) coordinate = i + 1;
        if (name.size() == 2 && name[0] == 'x' && name[1] >= '1' && name[1] <= '6')
            coordinate = static_cast<std::uint32_t>(name[1] - '0');
        if (coordinate == 0) return fault_at(begin, "'" + name + "' is none of x y z w x1 .. x6 sqrt abs min max");
        if (coordinate > out_.coordinates_) {
            out_.coordinates_ = coordinate;
            out_.coordinate_column_ = begin + 1;
        }
        return add(Code::coordinate, coordinate - 1);
    }
    bool arguments(const std::string& name, Code code, bool many) {
        if (!take('(')) return fault("'(' is due after " + name + ", not " + seen());
        if (!sum()) return false;
        if (!many) return take(')') ? add(code) : fault(name + " is of one number: ')' is due, not " + seen());
        if (peek() != ',') return fault(name + " is of two numbers or more: ',' is due, not " + seen());
        while (take(','))
            if (!sum() || !add(code)) return false;
        return take(')') || fault("',' or ')' is due, not " + seen());
    }

    Expression& out_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::string complaint_;
};

std::string Expression::parse(const std::string& text) {
    *this = {};
    if (text.size() > length_max) return "longer than " + std::to_string(length_max) + " characters";
    text_ = text;
    const std::string complaint = ExpressionParser(this).parse();
    if (!complaint.empty()) return complaint;
    // Without the blanks around it, as heads of files have it.
    const std::size_t first = text.find_first_not_of(' ');
    text_ = text.substr(first, text.find_last_not_of(' ') + 1 - first);
    if (coordinates_ > 0) coordinate_column_ -= first;
    return {};
}

double Expression::operator()(const double* x) const {
    std::vector<double> stack;
    const auto pop = [&] {
        const double top = stack.back();
        stack.pop_back();
        return top;
    };
    for (const Step& step : steps_) {
        if (step.code == Code::number || step.code == Code::coordinate) {
            stack.push_back(step.code == Code::number ? step.number : x[step.index]);
            continue;
        }
        const double b = pop();
        double result = 1;
        switch (step.code) {
        case Code::negate: result = -b; break;
        case Code::root: result = std::sqrt(b); break;
        case Code::size: result = std::fabs(b); break;
        case Code::power:
            for (std::uint32_t i = 0; i < step.index; i++) result *= b;
            break;
        case Code::add: result = pop() + b; break;
        case Code::subtract: result = pop() - b; break;
        case Code::multiply: result = pop() * b; break;
        case Code::divide: result = pop() / b; break;
        case Code::least: result = std::min(pop(), b); break;
        default: result = std::max(pop(), b); break;
        }
        stack.push_back(result);
    }
    return stack.back();
}

}  // namespace netmesh::tool
