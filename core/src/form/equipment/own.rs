//! Fields of the machine itself and of its probe.

use super::slot::{Held, Slot};
use crate::control::machine_data::TOOL_LENGTH_TYPE;
use crate::control::{AS_TURNING_TOOL, Control, Plane, Transverse};
use crate::machine::Setup;
use crate::machine::clock::Clock;
use crate::machine::temperature::Temperature;
use crate::range::Range;
use crate::workpiece::Probe;

/// What the machine is, as it is typed.
pub(super) struct Machine {
    name: String,
    /// 1: it turns.
    sort: i64,
    plane: i64,
    /// 0 DIAMOF, 1 DIAMON, 2 DIAM90.
    transverse: i64,
    spindle_positions: i64,
    minus: [Option<f64>; 3],
    plus: [Option<f64>; 3],
    centre: [f64; 3],
    deflection: Option<f64>,
    turret: [f64; 2],
    position: [f64; 3],
    temperature: Temperature,
    clock: Clock,
}

const TRANSVERSE: [Transverse; 3] = [Transverse::Radius, Transverse::Diameter, Transverse::AbsoluteDiameter];
const MINUS: [&str; 3] = ["equip-limit-x-minus", "equip-limit-y-minus", "equip-limit-z-minus"];
const PLUS: [&str; 3] = ["equip-limit-x-plus", "equip-limit-y-plus", "equip-limit-z-plus"];
const CENTRE: [&str; 3] = ["equip-centre-x", "equip-centre-y", "equip-centre-z"];
const START: [&str; 3] = ["equip-start-x", "equip-start-y", "equip-start-z"];

impl Machine {
    pub fn of(setup: &Setup) -> Machine {
        let control = &setup.control;
        Machine {
            name: setup.name.clone(),
            sort: i64::from(control.all_as_turning_tools()),
            plane: i64::from(control.plane.code()),
            transverse: TRANSVERSE.iter().position(|one| *one == control.transverse).unwrap_or(0) as i64,
            spindle_positions: i64::from(control.spindle_positions),
            minus: control.limits.minus,
            plus: control.limits.plus,
            centre: control.rotary_centre.0,
            deflection: control.deflection,
            turret: [setup.turret.diameter, setup.turret.width],
            position: setup.position.0,
            temperature: setup.temperature,
            clock: setup.clock,
        }
    }

    pub fn slots(&mut self, control: &Control) -> Vec<Slot<'_>> {
        let lathe = self.sort == 1;
        let mut all = vec![Slot::new("equip-name", Held::Text(&mut self.name))];
        if !control.make().registers {
            all.push(Slot::new("equip-sort", Held::Choice(&mut self.sort, &[0, 1])).cited("B:828"));
        }
        all.push(Slot::new("equip-plane", Held::Choice(&mut self.plane, &[17, 18, 19])));
        all.extend(lengths(START, &mut self.position));
        let limits = MINUS.into_iter().zip(&mut self.minus).chain(PLUS.into_iter().zip(&mut self.plus));
        all.extend(limits.map(|(key, limit)| Slot::new(key, Held::Limit(limit))));
        all.extend(lengths(CENTRE, &mut self.centre));
        if !control.make().registers {
            let positions = Held::Choice(&mut self.spindle_positions, &[0, 1]);
            all.push(Slot::new("equip-spindle", positions));
            let deflection = Slot::new("equip-deflection", Held::Limit(&mut self.deflection));
            all.push(deflection.within(Range::NOT_NEGATIVE).cited("B:1143-1161"));
        }
        if lathe {
            all.push(Slot::new("equip-transverse", Held::Choice(&mut self.transverse, &[0, 1, 2])));
            let turret = ["equip-turret-diameter", "equip-turret-width"].into_iter().zip(&mut self.turret);
            all.extend(turret.map(|(key, size)| Slot::new(key, Held::Length(size)).within(Range::NOT_NEGATIVE)));
        }
        let Temperature { spread, expansion } = &mut self.temperature;
        all.push(Slot::new("equip-temperature", Held::Plain(spread)).within(Range::NOT_NEGATIVE));
        all.push(Slot::new("equip-expansion", Held::Plain(expansion)));
        all.push(Slot::new("equip-clock", Held::Moment(&mut self.clock)));
        all
    }

    pub fn put(self, setup: &mut Setup) {
        let turned = i64::from(setup.control.all_as_turning_tools());
        setup.name = self.name;
        let control = &mut setup.control;
        control.plane = Plane::of(self.plane as u16).unwrap_or_default();
        control.transverse = TRANSVERSE.get(self.transverse as usize).copied().unwrap_or_default();
        control.spindle_positions = self.spindle_positions != 0;
        (control.limits.minus, control.limits.plus) = (self.minus, self.plus);
        control.rotary_centre.0 = self.centre;
        control.deflection = self.deflection;
        [setup.turret.diameter, setup.turret.width] = self.turret;
        setup.position.0 = self.position;
        setup.temperature = self.temperature;
        setup.clock = self.clock;
        if self.sort != turned {
            become_of_sort(control, self.sort == 1);
        }
    }
}

/// With the usual plane of its sort, and X as that sort has it.
fn become_of_sort(control: &mut Control, turns: bool) {
    control.set(TOOL_LENGTH_TYPE, if turns { AS_TURNING_TOOL } else { 0.0 });
    control.plane = if turns { Plane::G18 } else { Plane::G17 };
    control.transverse = if turns { Transverse::Diameter } else { Transverse::Radius };
}

/// A field for each of X Y Z.
pub(super) fn lengths<'a>(keys: [&'static str; 3], values: &'a mut [f64; 3]) -> impl Iterator<Item = Slot<'a>> {
    keys.into_iter().zip(values).map(|(key, value)| Slot::new(key, Held::Length(value)))
}

/// Fields of the probe as it really is.
pub(super) fn probe(probe: &mut Probe) -> Vec<Slot<'_>> {
    let Probe { radius, length, skew: [x, y], pre_travel: (travel, lobes), delay, repeatability: (scatter, _), .. } =
        probe;
    vec![
        Slot::new("equip-ball", Held::Diameter(radius)).within(Range::POSITIVE),
        Slot::new("equip-probe-length", Held::Length(length)),
        Slot::new("equip-skew-x", Held::Length(x)),
        Slot::new("equip-skew-y", Held::Length(y)),
        Slot::new("equip-travel", Held::Length(travel)),
        Slot::new("equip-travel-lobes", Held::Length(lobes)),
        Slot::new("equip-scatter", Held::Length(scatter)).within(Range::NOT_NEGATIVE),
        Slot::new("equip-delay", Held::Plain(delay)),
    ]
}
