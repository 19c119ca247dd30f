#include "physics/field_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "physics/data.h"
#include "physics/model.h"

namespace mjcourse {
namespace {

class FieldTable : public testing::Test {
 protected:
  FieldTable() {
    model_fields_.resize(static_cast<std::size_t>(mjc_model_fields(model_.get(), nullptr, 0)));
    mjc_model_fields(model_.get(), model_fields_.data(), static_cast<int>(model_fields_.size()));
    data_fields_.resize(
        static_cast<std::size_t>(mjc_data_fields(model_.get(), data_.get(), nullptr, 0)));
    mjc_data_fields(model_.get(), data_.get(), data_fields_.data(),
                    static_cast<int>(data_fields_.size()));
  }

  static const mjcField& find(const std::vector<mjcField>& fields, const std::string& owner,
                              const std::string& name) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const mjcField& f) {
      return f.owner == owner && f.name == name;
    });
    if (field == fields.end()) throw std::out_of_range("no field " + owner + '.' + name);
    return *field;
  }

  static std::size_t bytes(const mjcField& field) {
    constexpr std::size_t sizes[] = {sizeof(double), sizeof(float), sizeof(int), 1, 1};
    return sizes[field.type] * static_cast<std::size_t>(field.rows) *
           static_cast<std::size_t>(field.columns);
  }

  // Bytes of all model fields whose owner begins with `owner`.
  std::size_t bytes_in(const std::string& owner) const {
    std::size_t sum = 0;
    for (const mjcField& field : model_fields_) {
      if (std::string(field.owner).rfind(owner, 0) == 0) sum += bytes(field);
    }
    return sum;
  }

  Model model_ = load_model_text(R"(<mujoco><size nuser_body="2" nuserdata="3"/><worldbody>
        <body name="a" mocap="true"><geom size="0.1"/></body>
        <body name="b"><freejoint/><geom size="0.1" rgba="1 0 0 1"/><site name="s"/></body>
        <body name="c" pos="0 1 0"><joint name="j"/><geom size="0.1"/></body></worldbody>
      <actuator><motor joint="j"/></actuator><sensor><jointpos joint="j"/></sensor>
      <keyframe><key qpos="0 0 0 1 0 0 0 0.5"/></keyframe></mujoco>)")
                     .value();
  Data data_{model_};
  std::vector<mjcField> model_fields_;
  std::vector<mjcField> data_fields_;
};

TEST_F(FieldTable, KnowsNumbers) {
  const mjcField& nq = find(model_fields_, "", "nq");
  EXPECT_EQ(nq.scalar, 1);
  EXPECT_EQ(nq.type, mjcFIELD_INT);
  EXPECT_EQ(*static_cast<int*>(nq.address), 8);
  const mjcField& timestep = find(model_fields_, "opt", "timestep");
  EXPECT_EQ(timestep.scalar, 1);
  EXPECT_EQ(timestep.address, &model_->opt.timestep);
  const mjcField& time = find(data_fields_, "", "time");
  EXPECT_EQ(time.type, mjcFIELD_DOUBLE);
  EXPECT_EQ(time.address, &data_->time);
  EXPECT_EQ(find(model_fields_, "vis.global", "offwidth").type, mjcFIELD_INT);
  EXPECT_EQ(find(model_fields_, "vis.map", "force").type, mjcFIELD_FLOAT);
}

TEST_F(FieldTable, KnowsArraysAndTheirShapes) {
  const mjcField& qpos = find(data_fields_, "", "qpos");
  EXPECT_EQ(qpos.scalar, 0);
  EXPECT_EQ(qpos.rows, 8);
  EXPECT_EQ(qpos.columns, 1);
  EXPECT_EQ(qpos.address, data_->qpos);
  const mjcField& qposadr = find(model_fields_, "", "jnt_qposadr");
  EXPECT_EQ(qposadr.rows, 2);
  EXPECT_EQ(qposadr.type, mjcFIELD_INT);
  EXPECT_EQ(static_cast<int*>(qposadr.address)[1], 7);
  const mjcField& rgba = find(model_fields_, "", "geom_rgba");
  EXPECT_EQ(rgba.rows, 3);
  EXPECT_EQ(rgba.columns, 4);
  EXPECT_EQ(rgba.type, mjcFIELD_FLOAT);
  EXPECT_EQ(find(model_fields_, "", "key_mpos").columns, 3);
  EXPECT_EQ(find(model_fields_, "", "jnt_limited").type, mjcFIELD_BYTE);
  EXPECT_EQ(find(model_fields_, "", "names").type, mjcFIELD_CHAR);
  EXPECT_EQ(find(model_fields_, "opt", "gravity").rows, 3);
  EXPECT_EQ(find(model_fields_, "stat", "center").rows, 3);
  EXPECT_EQ(find(model_fields_, "stat", "center").scalar, 0);
  EXPECT_EQ(find(model_fields_, "vis.rgba", "haze").rows, 4);
  EXPECT_EQ(find(data_fields_, "", "energy").rows, 2);
}

TEST_F(FieldTable, LeavesOutArraysOfStructs) {
  EXPECT_THROW(find(data_fields_, "", "contact"), std::out_of_range);
  EXPECT_THROW(find(data_fields_, "", "warning"), std::out_of_range);
  EXPECT_NO_THROW(find(data_fields_, "", "efc_force"));
}

// A field that MuJoCo has and the table forgot would leave a hole in the struct.
TEST_F(FieldTable, CoversTheSettingsToTheByte) {
  EXPECT_EQ(bytes_in("vis"), sizeof(mjVisual));
  EXPECT_EQ(bytes_in("stat"), sizeof(mjStatistic));
  EXPECT_EQ(bytes_in("opt"), sizeof(mjOption));
}

// MuJoCo lays out the arrays one after another in the model's buffer, each on a 64-byte boundary: a
// shape that is wrong, or a forgotten array, would leave a wider gap or overlap the next.
TEST_F(FieldTable, CoversTheModelsBuffer) {
  const char* end = static_cast<const char*>(model_->buffer);
  for (const mjcField& field : model_fields_) {
    if (*field.owner != '\0' || field.scalar || bytes(field) == 0) continue;
    const auto* begin = static_cast<const char*>(field.address);
    EXPECT_GE(begin, end) << field.name;
    EXPECT_LT(begin - end, 64) << field.name;
    end = begin + bytes(field);
  }
  EXPECT_LT(static_cast<const char*>(model_->buffer) + model_->nbuffer - end, 64);
}

TEST_F(FieldTable, NamesEachFieldOnce) {
  for (const auto& fields : {model_fields_, data_fields_}) {
    std::set<std::string> names;
    for (const mjcField& field : fields) {
      EXPECT_TRUE(names.insert(std::string(field.owner) + '.' + field.name).second) << field.name;
    }
  }
}

TEST_F(FieldTable, WritesNoMoreThanThereIsRoomFor) {
  mjcField fields[2] = {};
  const int count = mjc_model_fields(model_.get(), fields, 1);
  EXPECT_EQ(static_cast<std::size_t>(count), model_fields_.size());
  EXPECT_NE(fields[0].name, nullptr);
  EXPECT_EQ(fields[1].name, nullptr);
}

}  // namespace
}  // namespace mjcourse
