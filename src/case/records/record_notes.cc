#include "record_notes.h"

#include "base/quoted.h"
#include "record_layout.h"
#include "record_table.h"

namespace upbead {

namespace {

/// A history has one value.
void note_further_values(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes) {
  if (layout.values.size() < 2) return;
  std::string what = column_text(table, layout.values[1]);
  if (layout.values.size() > 2) what += " and " + std::to_string(layout.values.size() - 2) + " more";
  notes.left_out.push_back({what, "a history has one value, here " + in_quotes(table.names[layout.values[0]])});
}

void note_history(const Case& input, const std::string& file, RecordNotes& notes) {
  if (file.empty()) return;
  const CsvTable table = read_record_head(input.resolve(file));
  const RecordLayout layout = layout_of(table);
  note_layout(table, layout, notes);
  note_further_values(table, layout, notes);
}

void note_gauges(const Case& input, const GaugeSource& source, RecordNotes& notes) {
  const CsvTable table = read_record_head(input.resolve(source.gauges));
  RecordLayout layout = layout_of(table);
  if (source.sampling_rate) layout.time.reset();
  note_layout(table, layout, notes);
}

}  // namespace

RecordNotes record_notes(const Case& input) {
  RecordNotes notes;
  for (const auto& [name, source] : input.sources) note_history(input, source.history, notes);
  for (const auto& [name, by] : input.gauges) note_gauges(input, by.source, notes);
  note_history(input, input.uplift_history, notes);
  if (input.uplift_gauges) note_gauges(input, input.uplift_gauges->source, notes);
  return notes;
}

}  // namespace upbead
