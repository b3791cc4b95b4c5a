// Training by GEGELATI on this project's pendulum: three torques, and the instructions and parameters of preset `gegelati`.
//
// With GEGELATI 1.4.0 (https://github.com/gegelati/gegelati at e531a2f) built as `Release` and installed:
//
//     g++ -std=c++17 -O3 -DNDEBUG -DCODE_GENERATION benches/peers/gegelati.cpp -lGEGELATI -lpthread -o gegelati
//     ./gegelati SEED GENERATIONS
//
// Prints environment steps, CPU seconds of the generations, and million steps a second. Beside it,
// `cargo run --release -p tpg-train -- config gegelati` with the section
//
//     [problem]
//     name = "pendulum"
//     levels = 3
//
// in place of its own, `tpg-train tpg --config … --seed SEED --generations GENERATIONS --threads 1 --out RUN`: CPU seconds in
// RUN/time.json, and in the last row of RUN/generations.jsonl the steps of training and of the choice among graphs.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <gegelati.h>

namespace {

const double PI = 3.14159265358979323846;
unsigned long long steps = 0;

// Gymnasium's Pendulum-v1: `tpg-train/problems/src/pendulum.rs`.
class Pendulum : public Learn::LearningEnvironment {
  public:
    Pendulum() : LearningEnvironment(3), cosine(1), sine(1), speed(1) {}

    std::vector<std::reference_wrapper<const Data::DataHandler>> getDataSources() override {
        return {cosine, sine, speed};
    }

    void reset(size_t seed, Learn::LearningMode mode, uint16_t, uint64_t) override {
        random.setSeed(Data::Hash<size_t>()(seed) ^ Data::Hash<Learn::LearningMode>()(mode));
        angle = random.getDouble(-PI, PI);
        velocity = random.getDouble(-1.0, 1.0);
        score = 0.0;
        show();
    }

    void doAction(uint64_t action) override {
        LearningEnvironment::doAction(action);
        const double torque = 2.0 * (static_cast<double>(action) - 1.0);
        double turned = angle + PI;
        if (!(turned >= 0.0 && turned < 2.0 * PI)) {
            turned = std::fmod(turned, 2.0 * PI);
            turned += turned < 0.0 ? 2.0 * PI : 0.0;
        }
        const double off = turned - PI;
        score -= off * off + 0.1 * velocity * velocity + 0.001 * torque * torque;
        velocity += (15.0 * sine_now + 3.0 * torque) * 0.05;
        velocity = std::fmin(std::fmax(velocity, -8.0), 8.0);
        angle += velocity * 0.05;
        show();
        steps++;
    }

    bool isCopyable() const override { return true; }
    Learn::LearningEnvironment *clone() const override { return new Pendulum(*this); }
    double getScore() const override { return score; }
    bool isTerminal() const override { return false; }

  private:
    Mutator::RNG random;
    Data::PrimitiveTypeArray<double> cosine, sine, speed;
    double angle = 0.0, velocity = 0.0, score = 0.0, sine_now = 0.0;

    void show() {
        sine_now = std::sin(angle);
        cosine.setDataAt(typeid(double), 0, std::cos(angle));
        sine.setDataAt(typeid(double), 0, sine_now);
        speed.setDataAt(typeid(double), 0, velocity);
    }
};

} // namespace

int main(int count, char **arguments) {
    const int seed = count > 1 ? std::atoi(arguments[1]) : 1;
    const int generations = count > 2 ? std::atoi(arguments[2]) : 30;

    Instructions::Set set;
    auto two = [&](auto function) { set.add(*new Instructions::LambdaInstruction<double, double>(function)); };
    auto one = [&](auto function) { set.add(*new Instructions::LambdaInstruction<double>(function)); };
    two([](double a, double b) -> double { return a - b; });
    two([](double a, double b) -> double { return a + b; });
    two([](double a, double b) -> double { return a * b; });
    two([](double a, double b) -> double { return a / b; });
    two([](double a, double b) -> double { return a < b ? -a : a; });
    one([](double a) -> double { return std::cos(a); });
    one([](double a) -> double { return std::sin(a); });
    one([](double a) -> double { return std::log(a); });
    one([](double a) -> double { return std::exp(a); });

    // GEGELATI's defaults, which are preset `gegelati`'s, but for the first population and the length of an episode.
    Learn::LearningParameters parameters;
    parameters.mutation.tpg.initNbRoots = 100;
    parameters.maxNbActionsPerEval = 200;
    parameters.nbThreads = 1;

    Pendulum pendulum;
    Learn::LearningAgent agent(pendulum, set, parameters);
    agent.init(static_cast<uint64_t>(seed));
    const std::clock_t before = std::clock();
    for (int generation = 0; generation < generations; generation++) {
        agent.trainOneGeneration(static_cast<uint64_t>(generation));
    }
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    std::printf("%llu steps, %.2f CPU s, %.3f million a second\n", steps, seconds, static_cast<double>(steps) / seconds / 1e6);
    return 0;
}
