'use strict';
(() => {
  const $ = (id) => document.getElementById(id);
  const lesson = JSON.parse($('lesson').textContent);
  const words = (index) => lesson.words[index];
  const player = $('player');
  /** Shows a text of the lesson as HTML, with its pictures and links. */
  const fill = (element, html) => {
    element.innerHTML = html;
    element.querySelectorAll('img').forEach((image) => { image.src = lesson.pictures[image.dataset.picture]; });
    element.querySelectorAll('a').forEach((link) => {
      link.onclick = (event) => {
        event.preventDefault();
        goToPage(Number(link.dataset.page));
      };
    });
    return element;
  };
  const given = lesson.pages.map(() => []); // the answers to the question of each page, in order: { answer, right }
  const seen = lesson.pages.map(() => false); // whether Show me was asked before a right answer to each question
  let page = 0, shownRun = -1, ready = false, shownAnswer = false;
  /** What the player shows: { done, inner, improve, place, picked }; null before its first word. */
  let moment = null;
  const light = matchMedia('(prefers-color-scheme: light)').matches;
  document.documentElement.classList.toggle('light', light);

  // ---- The player ----

  /** Returns the document of the player with a run. */
  const playerOf = (run) => '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"></head><body>' +
    $('player-parts').innerHTML.replace('<!--style-->', () => '<style>' + $('player-style').textContent + '</style>').replace('<!--run-->', () => '<script type="application/json" id="run">' + $('run' + run).textContent + '<' + '/script>') +
    '</body></html>';
  const tellTheme = () => {
    if (ready) { player.contentWindow.postMessage({ forefront: 'theme', light: document.documentElement.classList.contains('light') }, '*'); }
  };
  const goTo = (at) => {
    const { view, cells, numbers, bare, colours } = lesson.pages[page];
    if (ready) {
      player.contentWindow.postMessage({ forefront: 'goTo', done: at[0], event: at[1], improve: at[2], follow: view.follow === 1,
        box: view.box || null, cells: cells === 1, numbers: numbers === 1, bare: bare === 1 && at === lesson.pages[page].at,
        values: colours && (colours.tint || at === lesson.pages[page].at) ? colours : null }, '*');
    }
  };
  const showScene = () => {
    const { run, at } = lesson.pages[page];
    player.hidden = run < 0;
    if (run < 0 || run === shownRun) {
      if (run >= 0) { goTo(at); }
      return;
    }
    shownRun = run;
    ready = false;
    moment = null;
    player.srcdoc = playerOf(run);
  };
  addEventListener('message', (event) => {
    if (event.source !== player.contentWindow || !event.data) { return; }
    if (event.data.forefront === 'ready') {
      ready = true;
      tellTheme();
      goTo(lesson.pages[page].at);
    } else if (event.data.forefront === 'moment' && ready) {
      const before = moment;
      moment = event.data;
      const same = before && before.done === moment.done && before.inner === moment.inner && before.improve === moment.improve;
      if (moment.picked < 0 && same) { return; }
      checkTask();
    }
  });

  // ---- The question ----

  const questionNow = () => lesson.pages[page].question;
  const solved = () => given[page].some((answer) => answer.right);
  const reply = (right, html) => {
    $('reply').className = right ? 'right' : 'wrong';
    fill($('reply'), html);
  };
  const answer = (text, right, why, hint) => {
    given[page].push({ answer: text, right });
    reply(right, right ? why || 'Right.' : hint || questionNow().hint || 'Not yet. Try again.');
  };
  /** A task is done at the listed moments: [advances done, within the next one, moment of the improvement, candidate or -1, words]. */
  const checkTask = () => {
    const question = questionNow();
    if (!question || !question.done || !moment || solved()) { return; }
    const found = question.done.find(([done, inner, improve, picked]) => done === moment.done && (inner === 1) === moment.inner &&
      improve === moment.improve && (picked < 0 || picked === moment.picked));
    if (found && shownAnswer) { // by Show me, which is no answer
      reply(true, words(found[4]));
      return;
    }
    shownAnswer = false;
    if (found) {
      answer('advance ' + moment.place, true, words(found[4]));
    } else if (moment.picked >= 0 && question.asksForCandidate) {
      answer('candidate ' + (moment.picked + 1), false);
    }
  };
  const button = (text, act) => {
    const made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.onclick = act;
    return made;
  };
  const parse = (typed) => {
    const text = typed.includes('.') ? typed : typed.replace(',', '.');
    const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
    return Number.isFinite(value) ? value : NaN;
  };
  const answerNumber = () => {
    const field = $('typed'), value = parse(field.value.trim()), { number, within, why, mistakes } = questionNow();
    if (field.value.trim() === '' || Number.isNaN(value)) { reply(false, 'Expected a number such as 12 or 0.5.'); return; }
    const mistake = mistakes.find(([wrong, tolerance]) => Math.abs(value - wrong) <= tolerance);
    answer(field.value.trim(), Math.abs(value - number) <= within, why, mistake && mistake[2]);
  };
  const showQuestion = () => {
    const question = questionNow();
    $('question').hidden = !question;
    if (!question) { return; }
    fill($('asked'), question.html ?? question.text);
    $('reply').textContent = $('reply').className = '';
    $('show').hidden = !question.show;
    const answers = $('answers');
    answers.replaceChildren();
    if (question.choices) {
      question.choices.forEach(({ text, html, right, hint }, i) => {
        const choice = button('', () => {
          choice.className = right ? 'right' : 'wrong';
          answer(text, right, question.why, hint);
        });
        fill(choice, (i + 1) + '.&nbsp; ' + (html ?? text));
        answers.append(choice);
      });
    } else if ('number' in question) {
      const row = document.createElement('div'), field = document.createElement('input');
      row.className = 'number';
      field.id = 'typed';
      field.inputMode = 'decimal';
      field.setAttribute('aria-label', 'Your answer, a number');
      row.append(field, button('Check', answerNumber));
      answers.append(row);
    }
    if (question.note) { reply(false, question.note); }
    if (solved()) { reply(true, 'Answered.'); }
  };
  $('question').onsubmit = (event) => {
    event.preventDefault();
    if ($('typed')) { answerNumber(); }
  };
  $('show').onclick = () => {
    shownAnswer = true;
    seen[page] = seen[page] || !solved();
    goTo(questionNow().show);
  };

  // ---- Pages ----

  const showPage = () => {
    const { title, text, note } = lesson.pages[page];
    $('number').textContent = 'Page ' + (page + 1) + ' of ' + lesson.pages.length;
    $('heading').textContent = title;
    $('text').replaceChildren(...text.map((paragraph) => fill(document.createElement('p'), paragraph)));
    $('note').hidden = !note;
    $('note').textContent = note || '';
    $('previous').disabled = page === 0;
    $('following').disabled = page + 1 === lesson.pages.length;
    $('lesson-page').scrollTop = 0;
    moment = null;
    shownAnswer = false;
    showQuestion();
    showScene();
  };
  const goToPage = (to) => {
    if (to >= 0 && to < lesson.pages.length) { page = to; showPage(); }
  };
  $('previous').onclick = () => goToPage(page - 1);
  $('following').onclick = () => goToPage(page + 1);
  addEventListener('keydown', (event) => {
    const choice = Number(event.key);
    const choices = $('answers').querySelectorAll('button');
    if (event.key === 'PageDown' || event.key === 'PageUp') {
      event.preventDefault();
      goToPage(page + (event.key === 'PageDown' ? 1 : -1));
    } else if (event.target.tagName !== 'INPUT' && questionNow() && questionNow().choices && choice >= 1 && choice <= choices.length) {
      choices[choice - 1].click();
    }
  });

  // ---- Answers as a file ----

  $('save').onclick = () => {
    const record = { format: 'forefront-answers', version: 1, lesson: lesson.title, seed: lesson.seed,
      pages: lesson.pages.map(({ title, question }, i) => ({ title, question: question ? question.text : null, ...(seen[i] ? { shown: true } : {}), answers: given[i] })) };
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([JSON.stringify(record, null, 2) + '\n'], { type: 'application/json' }));
    link.download = lesson.title.replace(/[^\p{L}\p{N}]+/gu, '-').toLowerCase() + '-answers.json';
    link.click();
    URL.revokeObjectURL(link.href);
  };
  $('theme').onclick = () => {
    document.documentElement.classList.toggle('light');
    tellTheme();
  };

  document.title = lesson.title;
  $('title').textContent = lesson.title;
  $('about').textContent = lesson.about;
  showPage();
})();
