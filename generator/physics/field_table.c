#include "physics/field_table.h"

#include <mujoco/mjxmacro.h>

#include "physics/visual_fields.h"

/* mjxmacro.h names C types; these are the same in the table's terms. */
enum {
  TYPE_mjtNum = mjcFIELD_DOUBLE,
  TYPE_float = mjcFIELD_FLOAT,
  TYPE_int = mjcFIELD_INT,
  TYPE_mjtByte = mjcFIELD_BYTE,
  TYPE_char = mjcFIELD_CHAR,
  TYPE_struct = -1,
  TYPE_mjContact = TYPE_struct,
  TYPE_mjWarningStat = TYPE_struct,
  TYPE_mjTimerStat = TYPE_struct,
  TYPE_mjSolverStat = TYPE_struct
};

/* Of a field that mjxmacro.h does not list: its type, whether it is one number, how many it has. */
#define TYPE_OF(field)          \
  _Generic((field),             \
      double: mjcFIELD_DOUBLE,  \
      double*: mjcFIELD_DOUBLE, \
      float: mjcFIELD_FLOAT,    \
      float*: mjcFIELD_FLOAT,   \
      int: mjcFIELD_INT)
#define IS_SCALAR(field) _Generic((field), double*: 0, float*: 0, default: 1)
#define COUNT_OF(field) \
  ((int)(sizeof(field) / (TYPE_OF(field) == mjcFIELD_DOUBLE ? sizeof(double) : sizeof(float))))

typedef struct Table_ {
  mjcField* fields;
  int capacity;
  int count;
} Table;

static void add(Table* table, mjcField field) {
  if ((int)field.type == TYPE_struct) return;
  if (table->count < table->capacity) table->fields[table->count] = field;
  ++table->count;
}

static mjcField scalar(const char* owner, const char* name, int type, void* address) {
  mjcField field = {owner, name, (mjcFieldType)type, address, 1, 1, 1};
  return field;
}

static mjcField array(const char* owner, const char* name, int type, void* address, int rows,
                      int columns) {
  mjcField field = {owner, name, (mjcFieldType)type, address, rows, columns, 0};
  return field;
}

/* the structs inside the model: physics options, statistics, visual settings */
static void add_settings(Table* table, mjModel* model) {
#define X(type, name) add(table, scalar("opt", #name, TYPE_##type, &model->opt.name));
  MJOPTION_SCALARS
#undef X
#define X(name, size) add(table, array("opt", #name, TYPE_mjtNum, model->opt.name, size, 1));
  MJOPTION_VECTORS
#undef X
#define ADD(owner, name, field)                                                        \
  {                                                                                    \
    mjcField added = array(owner, name, TYPE_OF(field), &(field), COUNT_OF(field), 1); \
    added.scalar = IS_SCALAR(field);                                                   \
    add(table, added);                                                                 \
  }
#define X(group, name) ADD("vis." #group, #name, model->vis.group.name)
  MJC_VISUAL_FIELDS
#undef X
#define X(name) ADD("stat", #name, model->stat.name)
  MJC_STATISTIC_FIELDS
#undef X
#undef ADD
}

int mjc_model_fields(mjModel* model, mjcField* fields, int capacity) {
  Table table = {fields, capacity, 0};
  MJMODEL_POINTERS_PREAMBLE(model)
#define X(name) add(&table, scalar("", #name, TYPE_int, &model->name));
  MJMODEL_INTS
#undef X
#define X(type, name, rows, columns) \
  add(&table, array("", #name, TYPE_##type, model->name, model->rows, columns));
  MJMODEL_POINTERS
#undef X
  add_settings(&table, model);
  return table.count;
}

int mjc_data_fields(const mjModel* model, mjData* data, mjcField* fields, int capacity) {
  Table table = {fields, capacity, 0};
  MJDATA_POINTERS_PREAMBLE(model)
#define X(type, name) add(&table, scalar("", #name, TYPE_##type, &data->name));
  MJDATA_SCALAR
#undef X
#define X(type, name, rows, columns) \
  add(&table, array("", #name, TYPE_##type, data->name, rows, columns));
  MJDATA_VECTOR
#undef X
#define X(type, name, rows, columns) \
  add(&table, array("", #name, TYPE_##type, data->name, model->rows, columns));
  MJDATA_POINTERS
#undef X
  return table.count;
}
