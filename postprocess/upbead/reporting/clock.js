// The time that the moving section and the plots over time show together.
"use strict";
const clock = {
  readers: [],  // called with the time that is shown; at first, before anybody has moved it, with true besides
  move: null,  // of the section, where there is one: (time) goes to the frame next to it
  step: null,  // (frames) goes on by so many
  tell(time, begins = false) {
    for (const reader of this.readers) reader(time, begins);
  },
};
