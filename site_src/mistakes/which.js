/* Which mistake is this? One chooses before one is told: choices become buttons, and the first one counts. Without this script the
   page still has questions and answers. */
(() => {
  const said = document.currentScript.dataset;
  const fill = (sentence, values) => sentence.replace(/\{(\w+)\}/g, (_, key) => values[key]);
  const made = (className, ...content) => {
    const button = document.createElement("button");
    button.type = "button";
    button.className = className;
    button.append(...content);
    return button;
  };

  /** told: is called once, with whether the first choice was right. */
  function ask(question, told) {
    const options = [...question.querySelectorAll(".options > li")];
    const right = options.find((option) => "right" in option.dataset);
    const [answer, verdict] = [question.querySelector("details"), question.querySelector(".verdict")];
    const buttons = options.map((option) => made("option", ...option.childNodes));
    function choose(k) {
      if (question.classList.contains("answered")) return;
      const isRight = options[k] === right;
      const isTry = !answer.open; // who has read the answer guesses no more
      question.classList.add("answered");
      options[k].classList.add("is-yours");
      right.classList.add("is-right");
      buttons.forEach((button, j) => {
        button.setAttribute("aria-pressed", String(j === k));
        button.setAttribute("aria-disabled", "true");
      });
      answer.open = true;
      verdict.textContent = isRight ? said.right : fill(said.wrong, { letter: right.querySelector(".letter").textContent });
      if (isTry) told(isRight);
    }
    options.forEach((option, k) => {
      option.append(buttons[k]);
      buttons[k].addEventListener("click", () => choose(k));
    });
  }

  for (const round of document.querySelectorAll(".round")) {
    const score = round.querySelector(".score");
    let [count, right] = [0, 0];
    for (const question of round.querySelectorAll(".question")) {
      ask(question, (isRight) => {
        count++;
        right += isRight ? 1 : 0;
        score.textContent = fill(said.score, { right, count });
      });
    }
  }

  /** For a teacher who prints them. */
  const answers = [...document.querySelectorAll(".question details")];
  const all = made("all-answers", said.open);
  all.addEventListener("click", () => {
    const open = answers.some((answer) => !answer.open);
    for (const answer of answers) answer.open = open;
    all.textContent = open ? said.close : said.open;
  });
  document.querySelector(".page-head").append(all);
})();
