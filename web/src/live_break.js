// What can break of an actuator or a sensor: the types of failure that fit it, each with its settings.
export class Breaker {
  constructor(form, facts, link) {
    Object.assign(this, { form, facts, link });
    form.addEventListener("submit", (e) => {
      e.preventDefault();
      this.send();
    });
  }

  open(actuator) {
    this.what = actuator in this.facts.actuators ? { actuator } : { sensor: actuator };
    const { title, failures } = this.facts.actuators[actuator] ?? this.facts.sensors[actuator];
    this.failures = failures;
    this.choice = document.createElement("select");
    this.choice.name = "type";
    this.choice.append(...failures.map(({ type }) => new Option(type.replaceAll("_", " "), type)));
    this.choice.addEventListener("change", () => this.settings());
    this.fields = made("span", { className: "settings" });
    this.about = made("p");
    const close = made("button", { type: "button", textContent: "Close" });
    close.addEventListener("click", () => (this.form.hidden = true));
    const label = made("label", { textContent: "failure" });
    label.append(this.choice);
    this.form.replaceChildren(made("strong", { textContent: `Break the ${title}` }), label, this.fields, made("button", { textContent: "Break" }), close, this.about);
    this.settings();
    this.form.hidden = false;
    this.choice.focus();
  }

  settings() {
    const { about, settings, example } = this.failures.find(({ type }) => type === this.choice.value);
    this.about.textContent = about;
    this.fields.replaceChildren(...Object.entries(settings).map(([name, schema]) => field(name, schema, example[name] ?? schema.default)));
  }

  async send() {
    const failure = { type: this.choice.value, ...this.what };
    for (const input of this.fields.querySelectorAll("[name]")) {
      const value = input.type === "checkbox" ? input.checked : input.type === "number" ? input.valueAsNumber : input.value;
      if (input.type === "checkbox" || input.value !== "") failure[input.name] = value;
    }
    const answer = await this.link.ask("break", { failure });
    if (answer.note === "done") this.form.hidden = true;
  }
}

// An input for one setting, from its JSON schema; one that may be left out may be empty.
function field(name, schema, value) {
  const [kind] = (schema.anyOf ?? [schema]).filter(({ type }) => type !== "null");
  const optional = schema.anyOf !== undefined;
  const label = made("label", { textContent: schema.title });
  let input;
  if (kind.enum) {
    input = made("select");
    input.append(...(optional ? [""] : []).concat(kind.enum).map((each) => new Option(each, each)));
    input.value = value ?? (optional ? "" : kind.enum[0]);
  } else if (kind.type === "boolean") {
    input = made("input", { type: "checkbox", checked: Boolean(value) });
  } else {
    input = made("input", { type: "number", step: "any", required: !optional && value === undefined });
    if (kind.minimum !== undefined) input.min = kind.minimum;
    if (kind.maximum !== undefined) input.max = kind.maximum;
    if (value !== undefined && value !== null) input.value = value;
  }
  input.name = name;
  label.append(input);
  return label;
}

function made(name, about = {}) {
  return Object.assign(document.createElement(name), about);
}
