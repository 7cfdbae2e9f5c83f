// The answers of one person: kept in the browser while the page may be closed, and written as CSV.

const COLUMNS = ['questionnaire', 'participant', 'age', 'gender', 'hearing', 'level', 'language', 'order', 'stimulus', 'answer', 'realism', 'views', 'seconds'];

const cell = (value) => (/[",\n\r]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : String(value ?? ''));

export class Answers {
  /** Goes on where the same questionnaire was left in this browser, or begins. */
  constructor(questionnaire) {
    this.key = `chereme-${questionnaire}`;
    this.state = this.restored() || {
      questionnaire, participant: [...crypto.getRandomValues(new Uint8Array(4))].map((b) => b.toString(16).padStart(2, '0')).join(''),
      sheet: null, rows: [],
    };
  }

  /** What was kept; browsers may forbid a page opened from disk to keep anything. */
  restored() {
    try { return JSON.parse(localStorage.getItem(this.key)); } catch { return null; }
  }

  keep() {
    try { localStorage.setItem(this.key, JSON.stringify(this.state)); } catch { /* it works without */ }
  }

  /** After the download the next person begins anew. */
  forget() {
    try { localStorage.removeItem(this.key); } catch { /* nothing was kept */ }
  }

  setSheet(sheet) { this.state.sheet = sheet; this.keep(); }
  add(row) { this.state.rows.push(row); this.keep(); }

  csv() {
    const { questionnaire, participant, sheet, rows } = this.state;
    const lines = rows.map((row, i) => ({ questionnaire, participant, ...sheet, order: i + 1, ...row }));
    return [COLUMNS, ...lines.map((line) => COLUMNS.map((name) => cell(line[name] ?? '')))].map((row) => row.join(',')).join('\r\n') + '\r\n';
  }
}
