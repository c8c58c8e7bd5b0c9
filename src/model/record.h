// Defects of a measured record, found from its samples alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"

namespace upbead {

/// Samples of one transducer, or of a force.
struct Record {
  std::string name;           ///< for messages
  std::vector<double> time;   ///< s, ascending
  std::vector<double> value;  ///< any unit, of the same length
  /// When a run ends in which it is a load, zero after its last sample (s); none: it is none, or that is not known.
  std::optional<double> end{};
};

/// Whether the samples come from an instrument, and are not the corners of an idealised history: ten or more at equal
/// intervals (to 1 %), or fifty or more at any intervals.
bool is_measured(const Record& record);

/// All warnings that apply to a measured record; none for other records.
///   record_dead        it never changes by more than 1e-6 of its largest value
///   record_saturated   it stays at its extreme, to 1e-6 of its range, for 5 samples or more between a rise and a
///                      fall: the instrument had reached its limit. The value is the number of samples. Voids
///                      the verdict, as the largest load is not in the record
///   record_drifting    it comes to rest between 3 and 50 % of its peak away from where it started, or moves by more
///                      than 3 % of the peak before the first event; both more slowly than a tenth of the slope of
///                      its rise (10 to 90 % of the peak), as the foot of a smooth rise is no drift. The value is
///                      that share of the peak
///   record_cut         it ends between 3 and 50 % of its peak away from where it started, and still moves faster; or
///                      more than 50 %, as a load that acts no more where the run goes on. Voids the verdict where the
///                      load jumps then by more than 5 % of its peak
///   record_too_coarse  fewer than 20 samples from the last crossing of a tenth of the peak to the peak
///   record_spikes      samples that differ from both neighbours by a fifth of the range while the neighbours agree
///                      to a twentieth
///   record_begun       its first sample is more than 5 % of its largest value, and it moves there, or comes back by
///                      half at its end. Voids the verdict, as those of lost_samples()
///   record_offset      it is more than 5 % of its largest value both there and at its end. Voids the verdict
/// and lost_samples().
NumberedWarnings record_warnings(const Record& record);

/// What an instrument, a logger or a file lost; also of records of 10 to 49 samples of which a fifth is not at equal
/// intervals:
///   record_gap      a step is five times as long as the usual ones on both sides of it. The value is that step. Voids
///                   the verdict where the record is more than 3 % of its peak away from its start beside it; where it
///                   is not, and both samples are equal, there is no warning
///   record_dropout  three equal samples or more between jumps of a fifth of the range within a sample, three times as
///                   large as any other change; or five that hold the last value until such a jump. The value is their
///                   number
NumberedWarnings lost_samples(const Record& record);

/// A transducer on a wall.
struct RecordAtHeight {
  double height = 0.;  ///< m
  Record record;
};

/// Of a record as a whole, where `told` has no record_cut:
///   load_drops      its last value is half of its largest or more, and the run goes on without it. Voids the verdict
///                   from 90 %
NumberedWarnings drop_warnings(const Record& record, const NumberedWarnings& told);

/// records_swapped: exchanging two of the records, all sampled at the same times, would make the pressures much
/// smoother over the height: the sum of squared second differences, over the 2,000 samples with the largest
/// pressures, falls below a quarter. Needs four records, in the order of ascending heights. The value is that ratio;
/// the text names the two records.
NumberedWarnings swapped_records(const std::vector<RecordAtHeight>& records);

}  // namespace upbead
