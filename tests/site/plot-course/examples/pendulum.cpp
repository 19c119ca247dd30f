// A pendulum by hand. It writes its reports itself, since the helper header takes long to compile.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

struct Column {
  const char* name;
  std::vector<double> values;
};

void report(std::ofstream& file, const char* name, const std::vector<Column>& table) {
  file.precision(17);
  file << R"({"table": ")" << name << R"(", "value": [)";
  for (const Column& column : table) {
    file << (&column == &table[0] ? "" : ", ") << "[\"" << column.name << "\", [";
    for (const double& x : column.values) file << (&x == &column.values[0] ? "" : ", ") << x;
    file << "]]";
  }
  file << "]}\n";
}

// One step of the semi-implicit Euler method, and one of the explicit.
void step(double h, double& q, double& v, bool implicit) {
  const double force = -9.81 * std::sin(q);
  const double before = v;
  v += h * force;
  q += h * (implicit ? v : before);
}

int main() {
  std::ofstream file(std::getenv("MJCOURSE_RECORDS"));
  std::vector<Column> energy{
      {"time", {}}, {"kinetic", {}}, {"potential", {}}, {"total", {}}, {"drift", {}}};
  double q = 2, v = 0;
  for (int i = 0; i <= 300; ++i) {
    const double kinetic = v * v / 2;
    const double potential = 9.81 * (1 - std::cos(q));
    const double start = 9.81 * (1 - std::cos(2.0));
    const double values[] = {i * 0.01, kinetic, potential, kinetic + potential,
                             kinetic + potential - start};
    for (int c = 0; c < 5; ++c) energy[c].values.push_back(values[c]);
    step(0.01, q, v, true);
  }
  report(file, "energy", energy);

  std::vector<Column> error{{"h", {}}, {"semi_implicit", {}}, {"explicit", {}}};
  for (const double h : {0.02, 0.01, 0.005, 0.002, 0.001, 0.0005}) {
    error[0].values.push_back(h);
    for (const bool implicit : {true, false}) {
      double position = 2, velocity = 0, near = 2, near_velocity = 0;
      for (int i = 0; i < std::lround(1 / h); ++i) step(h, position, velocity, implicit);
      for (int i = 0; i < 200000; ++i) step(5e-6, near, near_velocity, true);
      error[implicit ? 1 : 2].values.push_back(std::abs(position - near));
    }
  }
  report(file, "error", error);
  std::puts("two tables");
}
