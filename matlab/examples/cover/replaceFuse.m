function actions = replaceFuse(robot, aside, sensor, aux)
% Returns the actions that replace the fuse, where housing, screwdriver, stand, fuse and bin are seen.
  brass = [216 176 74];
  handle = [215 38 61];
  cap = [32 160 64];
  wood = [122 92 62];
  housing = findPlace('screws', brass, 1.55, sensor, aux);  % the heads, two by two around it
  screwdriver = findPlace('screwdriver', handle, 2.6, sensor, aux);
  spare = findPlace('good fuse', cap, 0.8, sensor, aux);
  stand = findPlace('stand', wood, 0.8, sensor, aux);
  waste = findPlace('bin', wood, 0.6, sensor, aux);
  screws = [pointAt(housing, -1.55, 0.75, 0); pointAt(housing, 1.55, 0.75, 0); ...
            pointAt(housing, 1.55, -0.75, 0); pointAt(housing, -1.55, -0.75, 0)];

  % Heights of the tips of the fingers that hold the knob of the cover, or a fuse: there, and on the way.
  knob = 1.4;
  knobOnStand = 1.2;
  over = 2.6;
  fuse = 0.3;
  fuseInside = 0.45;  % of the socket or the bin
  overFuse = 2.1;
  lift = 1;  % of a fuse that stands alone, before it rises on its way
  % Each part is planned when those before have ended: its planning then takes a step.
  actions = [look(@(s, a) turnScrews(robot, aside, screwdriver.middle, screws, true)), ...
             look(@(s, a) carryObject(robot, aside, housing, knob, stand, knobOnStand, over)), ...
             look(@(s, a) carryObject(robot, aside, housing, fuseInside, waste, fuseInside, overFuse)), ...
             look(@(s, a) carryObject(robot, aside, spare, fuse, housing, fuseInside, overFuse, lift)), ...
             look(@(s, a) carryObject(robot, aside, stand, knobOnStand, housing, knob, over)), ...
             look(@(s, a) turnScrews(robot, aside, screwdriver.middle, screws, false))];
end
