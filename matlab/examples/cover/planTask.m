function actions = planTask(robot, aside, sensor, aux)
% Plans the whole task from a picture: a cell of actions, see follow and grip.
  brass = [216 176 74]; handle = [215 38 61]; cap = [32 160 64]; wood = [122 92 62];
  % Upper faces at these heights: the heads of the screws, two by two around the housing, the handle, ...
  housing = findPlace('screws', brass, 1.55, sensor, aux);
  screwdriver = findPlace('screwdriver', handle, 2.6, sensor, aux);
  spare = findPlace('good fuse', cap, 0.8, sensor, aux);
  stand = findPlace('stand', wood, 0.8, sensor, aux);
  waste = findPlace('bin', wood, 0.6, sensor, aux);
  corners = [-1 1; 1 1; 1 -1; -1 -1] .* [1.55 0.75];
  screws = housing.middle + corners * [housing.x(1:2); housing.y(1:2)];

  % Heights of the tool that holds the knob of the cover, or a fuse: there, and on the way.
  knob = 2.2; knob_on_stand = 2; over = 3.4;
  fuse = 1.1; fuse_inside = 1.2; over_fuse = 2.9;
  actions = [planScrews(robot, aside, screwdriver.middle, screws, true), ...
             planCarry(robot, aside, housing, knob, stand, knob_on_stand, over), ...
             planCarry(robot, aside, housing, fuse_inside, waste, fuse_inside, over_fuse), ...
             planCarry(robot, aside, spare, fuse, housing, fuse_inside, over_fuse), ...
             planCarry(robot, aside, stand, knob_on_stand, housing, knob, over), ...
             planScrews(robot, aside, screwdriver.middle, screws, false)];
end
