"""What all parts of the learner talk about: blocks, their kinds, the areas that they cover, the steps of a task."""
